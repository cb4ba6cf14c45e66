#include "apps/headless_browser.h"

#include <fcntl.h>
#include <poll.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <sstream>
#include <stdexcept>

namespace explore::test
{
using nlohmann::json;

namespace
{
constexpr int kPatience_ms = 120'000;

/** What the browser reads from and writes to with --remote-debugging-pipe. */
constexpr int kItReads = 3, kItWrites = 4;

[[noreturn]] void become(const std::string& program, const std::string& home, int reads, int writes)
{
	// High numbers first: the pipes' own may be those that they have to become.
	constexpr int kHigh = 100;
	const int in = ::fcntl(reads, F_DUPFD, kHigh), out = ::fcntl(writes, F_DUPFD, kHigh);
	::dup2(in, kItReads);
	::dup2(out, kItWrites);
	::close(in);
	::close(out);
	const int silent = ::open("/dev/null", O_RDWR);
	for (const int descriptor : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) ::dup2(silent, descriptor);
	// It keeps things in both of these too.
	::setenv("HOME", home.c_str(), 1);
	::setenv("TMPDIR", home.c_str(), 1);
	const std::string folder = "--user-data-dir=" + home + "/profile";
	::execl(program.c_str(), program.c_str(), "--headless", "--no-sandbox", "--disable-gpu", "--disable-quic",
	        "--no-first-run", "--disable-background-networking", "--disable-component-update", "--disable-sync",
	        "--disable-dev-shm-usage", folder.c_str(), "--remote-debugging-pipe", nullptr);
	::_exit(127);
}
}  // namespace

std::optional<std::filesystem::path> HeadlessBrowser::find()
{
	const char* folders = std::getenv("PATH");
	std::istringstream path(folders != nullptr ? folders : "");
	for (std::string folder; std::getline(path, folder, ':');)
		for (const char* name : {"chromium", "chromium-browser", "google-chrome"})
			if (const auto program = std::filesystem::path(folder) / name; ::access(program.c_str(), X_OK) == 0)
				return program;
	return std::nullopt;
}

HeadlessBrowser::HeadlessBrowser(const std::filesystem::path& program, const std::filesystem::path& folder)
{
	std::filesystem::create_directories(folder);
	start(program.string(), folder.string());
	const json target = call("Target.createTarget", {{"url", "about:blank"}});
	m_session = call("Target.attachToTarget", {{"targetId", target["targetId"]}, {"flatten", true}})["sessionId"];
	for (const char* domain : {"Page", "Runtime", "Log", "Network"})
		call(std::string(domain) + ".enable", json::object());
}

void HeadlessBrowser::start(const std::string& program, const std::string& home)
{
	std::array<int, 2> to{}, from{};
	if (::pipe2(to.data(), O_CLOEXEC) != 0 || ::pipe2(from.data(), O_CLOEXEC) != 0)
		throw std::runtime_error("no pipe to the browser");
	m_process = ::fork();
	if (m_process < 0) throw std::runtime_error("fork failed");
	if (m_process == 0)
	{
		::setpgid(0, 0);  // with all the processes that it starts
		become(program, home, to[0], from[1]);
	}
	::close(to[0]);
	::close(from[1]);
	m_to = to[1];
	m_from = from[0];
	std::signal(SIGPIPE, SIG_IGN);  // a browser that ended is told by receive()
}

HeadlessBrowser::~HeadlessBrowser()
{
	::close(m_to);
	::close(m_from);
	::kill(-m_process, SIGKILL);
	::waitpid(m_process, nullptr, 0);
}

json HeadlessBrowser::receive()
{
	for (auto end = m_received.find('\0');; end = m_received.find('\0'))
	{
		if (end != std::string::npos)
		{
			json message = json::parse(m_received.substr(0, end));
			m_received.erase(0, end + 1);
			return message;
		}
		pollfd ready{m_from, POLLIN, 0};
		if (::poll(&ready, 1, kPatience_ms) <= 0) throw std::runtime_error("the browser does not answer");
		std::array<char, 65536> bytes{};
		const ssize_t got = ::read(m_from, bytes.data(), bytes.size());
		if (got <= 0) throw std::runtime_error("the browser ended");
		m_received.append(bytes.data(), static_cast<std::size_t>(got));
	}
}

void HeadlessBrowser::note(const json& event)
{
	const std::string method = event.value("method", "");
	if (method == "Page.loadEventFired") m_loaded = true;
	if (method == "Runtime.exceptionThrown" || method == "Log.entryAdded")
		m_complaints.push_back(event["params"].dump());
	if (method != "Network.requestWillBeSent") return;
	const std::string url = event["params"]["request"]["url"];
	if (!url.starts_with("file:") && !url.starts_with("data:")) m_complaints.push_back("asks for " + url);
}

json HeadlessBrowser::call(const std::string& method, const json& parameters)
{
	json message{{"id", ++m_calls}, {"method", method}, {"params", parameters}};
	if (!m_session.empty()) message["sessionId"] = m_session;
	const std::string text = message.dump() + '\0';
	for (std::size_t sent = 0; sent < text.size();)
	{
		const ssize_t now = ::write(m_to, text.data() + sent, text.size() - sent);
		if (now <= 0) throw std::runtime_error("the browser does not listen");
		sent += static_cast<std::size_t>(now);
	}
	while (true)
	{
		const json answer = receive();
		if (answer.value("id", 0) != m_calls)
		{
			note(answer);
			continue;
		}
		if (answer.contains("error")) throw std::runtime_error(method + ": " + answer["error"].dump());
		return answer["result"];
	}
}

void HeadlessBrowser::resize(int width_px, int height_px)
{
	call("Emulation.setDeviceMetricsOverride",
	     {{"width", width_px}, {"height", height_px}, {"deviceScaleFactor", 1}, {"mobile", width_px < 500}});
}

void HeadlessBrowser::open(const std::filesystem::path& page)
{
	m_loaded = false;
	call("Page.navigate", {{"url", "file://" + std::filesystem::absolute(page).string()}});
	while (!m_loaded) note(receive());
}

json HeadlessBrowser::evaluate(const std::string& expression)
{
	const json result =
	    call("Runtime.evaluate", {{"expression", expression}, {"awaitPromise", true}, {"returnByValue", true}});
	if (result.contains("exceptionDetails")) throw std::runtime_error(result["exceptionDetails"].dump());
	return result["result"].value("value", json());
}

void HeadlessBrowser::press(const std::string& key, int code)
{
	for (const char* type : {"keyDown", "keyUp"})
		call("Input.dispatchKeyEvent",
		     {{"type", type}, {"key", key}, {"windowsVirtualKeyCode", code}, {"nativeVirtualKeyCode", code}});
}
}  // namespace explore::test
