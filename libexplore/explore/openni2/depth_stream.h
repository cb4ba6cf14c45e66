// The depth stream of one camera or recording, with its colour stream where that is asked for: opened, set up, and read
// frame by frame.
#pragma once

#include <explore/openni2/library.h>
#include <explore/openni2/raw_depth.h>
#include <explore/sources/source_config.h>

#include <chrono>
#include <memory>
#include <optional>
#include <string>

namespace explore::openni2
{
class DepthStream
{
public:
	enum class Origin
	{
		camera,
		recording
	};
	/** Opens what `uri` names – a camera's URI, a recording's path – and starts its streams. Of a camera, size, rate
	 *  and registration become what `config` asks for. A Library must be there as long as the stream is. Throws
	 *  ConfigError for what the camera does not have, SensorLost for all else, with OpenNI2's reason. */
	DepthStream(const std::string& uri, Origin origin, Openni2Config config);
	~DepthStream();
	DepthStream(const DepthStream&) = delete;
	DepthStream& operator=(const DepthStream&) = delete;

	/** The next frame; no value when none came in time. It never waits for its colour image. Throws BadFrame. */
	std::optional<RawDepth> read(std::chrono::milliseconds timeout);
	/** Of a recording, as it says itself. */
	[[nodiscard]] int frameCount() const;
	/** By the stream's own count, of the frame that was read last. */
	[[nodiscard]] int frameNumber() const;

private:
	struct Handles;
	void openDevice(const std::string& uri);
	void start(const std::string& uri);
	void setUpCamera();
	void setMode();
	void setRegistration();
	void setUpRecording();
	[[nodiscard]] bool awaitDepth(std::chrono::milliseconds timeout);
	[[nodiscard]] std::optional<ColorImage> colorFor(const RawDepth& raw) const;
	[[nodiscard]] CameraIntrinsics intrinsicsFor(int width_px, int height_px) const;

	Openni2Config m_config;
	std::unique_ptr<Handles> m_handles;
	bool m_mirrored = false;
	FieldOfView m_view;
};
}  // namespace explore::openni2
