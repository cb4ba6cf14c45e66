// Chromium without a window, driven over a pipe, to see a page as its readers do.
#pragma once

#include <sys/types.h>

#include <filesystem>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

namespace explore::test
{
class HeadlessBrowser
{
public:
	/** The program; no value where it is not installed. */
	static std::optional<std::filesystem::path> find();

	/** Starts it with `folder`, which has to have a short name (sockets are made in it), for all that it keeps. Throws
	 *  std::runtime_error. */
	HeadlessBrowser(const std::filesystem::path& program, const std::filesystem::path& folder);
	~HeadlessBrowser();
	HeadlessBrowser(const HeadlessBrowser&) = delete;
	HeadlessBrowser& operator=(const HeadlessBrowser&) = delete;

	/** Of the window [CSS pixels]; for pages that are opened later. */
	void resize(int width_px, int height_px);
	/** Returns when the page and its scripts are loaded. */
	void open(const std::filesystem::path& page);
	/** The value of an expression, a promise's when it is kept. Throws std::runtime_error where it fails. */
	nlohmann::json evaluate(const std::string& expression);
	/** A key by its name in KeyboardEvent.key and its number there, pressed and released. */
	void press(const std::string& key, int code);

	/** What went wrong in scripts, and what was asked of the network, so far. */
	[[nodiscard]] const std::vector<std::string>& complaints() const { return m_complaints; }

private:
	nlohmann::json call(const std::string& method, const nlohmann::json& parameters);
	nlohmann::json receive();
	void note(const nlohmann::json& event);
	void start(const std::string& program, const std::string& home);

	pid_t m_process = -1;
	int m_to = -1, m_from = -1;
	int m_calls = 0;
	bool m_loaded = false;
	std::string m_session, m_received;
	std::vector<std::string> m_complaints;
};
}  // namespace explore::test
