// Watches whether a camera's depth makes flat walls look bent, and says so once.
#pragma once

#include <explore/perception/wall_bend.h>
#include <explore/pipeline/explorer_config.h>

#include <optional>
#include <string>

namespace explore::app
{
/** Looks at two frames a second of the recording: what frames say that follow each other more closely is the same. */
class DepthCheck
{
public:
	explicit DepthCheck(const ExplorerConfig& config) : m_config(config) {}

	/** The remark for the user, with the first frame that makes it clear; no value with all others. Clouds without an
	 *  image are passed over. */
	std::optional<std::string> look(const DepthFrame& frame);
	/** Writes or reads what look() changes. */
	template <class Archive>
	void exchange(Archive& archive)
	{
		archive(m_bend), archive(m_looked), archive(m_said);
	}

private:
	const ExplorerConfig& m_config;
	WallBend m_bend;
	std::optional<mrpt::Clock::time_point> m_looked;
	bool m_said = false;
};
}  // namespace explore::app
