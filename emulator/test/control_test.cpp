// SPDX-License-Identifier: GPL-3.0-or-later
// The control socket: lines in, lines out, whatever the clients do.
#include "support.h"

#include <memory>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/un.h>
#include <unistd.h>

extern "C" {
#include "control.h"
}

namespace {

struct Server {
  explicit Server(const std::string &at) : path(at) {
    EXPECT_EQ(control_open(&socket, path.c_str(), {this, perform}, error, sizeof error), 0) << error;
  }
  ~Server() { control_close(&socket); }

  static int perform(void *context, const char *line, size_t length, char *error, size_t size) {
    Server *server = static_cast<Server *>(context);
    server->lines.emplace_back(line, length);
    snprintf(error, size, "no \"%s\"", "good");
    return server->lines.back() == "good" ? 0 : -1;
  }

  std::string path;
  char error[512];
  control socket;
  std::vector<std::string> lines;
};

struct Client {
  explicit Client(const std::string &path) : fd(socket(AF_UNIX, SOCK_STREAM | SOCK_NONBLOCK, 0)) {
    sockaddr_un address = {};
    address.sun_family = AF_UNIX;
    snprintf(address.sun_path, sizeof address.sun_path, "%s", path.c_str());
    EXPECT_EQ(connect(fd, reinterpret_cast<sockaddr *>(&address), sizeof address), 0) << path;
  }
  ~Client() { close(fd); }

  bool send(const std::string &text) { return write(fd, text.data(), text.size()) == ssize_t(text.size()); }
  std::string receive() {
    char bytes[65536];
    ssize_t length = read(fd, bytes, sizeof bytes);
    return length > 0 ? std::string(bytes, static_cast<size_t>(length)) : "";
  }

  int fd;
};

const std::string OK = "{\"ok\":true}\n";
const std::string NOT_OK = "{\"error\":\"no \\\"good\\\"\"}\n";

}  // namespace

TEST(Control, each_line_is_answered_by_one_line) {
  Scratch scratch;
  Server server(scratch.path("new/control"));
  Client client(server.path);
  client.send("good\nbad\ngo");
  control_exchange(&server.socket);
  EXPECT_EQ(client.receive(), OK + NOT_OK);
  client.send("od\n");
  control_exchange(&server.socket);
  EXPECT_EQ(client.receive(), OK);
  EXPECT_EQ(server.lines, (std::vector<std::string>{"good", "bad", "good"}));
}

TEST(Control, a_line_may_come_byte_by_byte) {
  Scratch scratch;
  Server server(scratch.path("control"));
  Client client(server.path);
  for (char byte : std::string("good\n")) {
    client.send(std::string(1, byte));
    control_exchange(&server.socket);
  }
  EXPECT_EQ(client.receive(), OK);
}

TEST(Control, several_clients_each_get_their_own_replies) {
  Scratch scratch;
  Server server(scratch.path("control"));
  std::vector<std::unique_ptr<Client>> clients;
  for (int i = 0; i < CONTROL_CLIENTS + 1; i++) {
    clients.push_back(std::make_unique<Client>(server.path));
    clients.back()->send(i % 2 ? "good\n" : "bad\n");
  }
  control_exchange(&server.socket);
  for (int i = 0; i < CONTROL_CLIENTS; i++) EXPECT_EQ(clients[i]->receive(), i % 2 ? OK : NOT_OK);
  EXPECT_EQ(clients.back()->receive(), "");
  clients.erase(clients.begin());  // makes room for the one that waits
  control_exchange(&server.socket);
  control_exchange(&server.socket);
  EXPECT_EQ(clients.back()->receive(), NOT_OK);
}

TEST(Control, a_line_that_is_too_long_is_refused_and_the_next_one_is_taken) {
  Scratch scratch;
  Server server(scratch.path("control"));
  Client client(server.path);
  client.send(std::string(CONTROL_MAX_LINE, 'x') + "\n" + std::string(5000, 'x') + "\ngood\n");
  for (int i = 0; i < 10; i++) control_exchange(&server.socket);
  EXPECT_EQ(client.receive(),
            NOT_OK + "{\"error\":\"the line is longer than 1024 bytes; expected one command a line\"}\n" + OK);
}

TEST(Control, a_client_that_does_not_read_is_not_served_and_stops_nobody) {
  Scratch scratch;
  Server server(scratch.path("control"));
  Client idle(server.path), client(server.path);
  size_t before = 1;
  for (size_t same = 0; same < 1000; same = server.lines.size() == before ? same + 1 : 0) {
    before = server.lines.size();
    idle.send("good\n");
    control_exchange(&server.socket);
  }
  client.send("bad\n");
  control_exchange(&server.socket);
  EXPECT_EQ(client.receive(), NOT_OK);
  EXPECT_EQ(idle.receive().substr(0, OK.size()), OK);
}

TEST(Control, a_client_that_goes_away_makes_room) {
  Scratch scratch;
  Server server(scratch.path("control"));
  for (int i = 0; i < 3 * CONTROL_CLIENTS; i++) {
    Client client(server.path);
    client.send("good\ngo");
    control_exchange(&server.socket);
  }
  EXPECT_EQ(server.lines.size(), 3u * CONTROL_CLIENTS);
}

TEST(Control, a_client_that_floods_is_served_a_few_lines_at_a_time) {
  Scratch scratch;
  Server server(scratch.path("control"));
  Client client(server.path);
  ASSERT_TRUE(client.send(std::string(500, '\n')));
  control_exchange(&server.socket);
  EXPECT_EQ(server.lines.size(), size_t(CONTROL_LINES));
  for (int i = 0; i < 500; i++) {
    control_exchange(&server.socket);
    client.receive();
  }
  EXPECT_EQ(server.lines.size(), 500u);
}

TEST(Control, a_last_line_needs_no_end) {
  Scratch scratch;
  Server server(scratch.path("control"));
  Client client(server.path);
  ASSERT_TRUE(client.send("good\ngood"));
  shutdown(client.fd, SHUT_WR);
  for (int i = 0; i < 5; i++) control_exchange(&server.socket);
  EXPECT_EQ(server.lines, (std::vector<std::string>{"good", "good"}));
  EXPECT_EQ(client.receive(), OK + OK);
}

TEST(Control, the_socket_is_for_its_user_only_and_goes_at_the_end) {
  Scratch scratch;
  struct stat status;
  {
    Server server(scratch.path("control"));
    ASSERT_EQ(stat(server.path.c_str(), &status), 0);
    EXPECT_EQ(status.st_mode & 0777, 0700u & status.st_mode);
  }
  EXPECT_FALSE(exists(scratch.path("control")));
}

static std::string refused(const std::string &path) {
  control c;
  char error[512] = "";
  EXPECT_EQ(control_open(&c, path.c_str(), {}, error, sizeof error), -1);
  control_close(&c);
  return error;
}

TEST(Control, a_stale_socket_is_replaced_and_nothing_else) {
  Scratch scratch;
  std::string path = scratch.path("control");
  sockaddr_un address = {};
  address.sun_family = AF_UNIX;
  snprintf(address.sun_path, sizeof address.sun_path, "%s", path.c_str());
  int stale = socket(AF_UNIX, SOCK_STREAM, 0);
  ASSERT_EQ(bind(stale, reinterpret_cast<sockaddr *>(&address), sizeof address), 0);
  close(stale);
  Server server(path);
  EXPECT_EQ(refused(path), "--control " + path + ": another emulator uses it; end that one or choose another path");
  EXPECT_TRUE(exists(path));
  std::string file = scratch.write("file", "precious");
  EXPECT_EQ(refused(file),
            "--control " + file + ": there is something that is no socket; remove it or choose another path");
  EXPECT_EQ(read_text(file), "precious");
  std::string longer = scratch.path(std::string(120, 'x'));
  EXPECT_EQ(refused(longer), "--control " + longer + ": the path is too long; expected at most 107 bytes");
}
