Feature: boards and their agents

  @verify
  Scenario Outline: a sketch never returns from <what>: its board is reset, and works again
    Given a robot with Hanging
    When the agent robot gets the goal do(<what>)
    Then within 4 min it no longer believes works
    And within 4 min it believes works
    And it has printed "the board is off:": ports/robot: the board has taken a request and not answered it

    Examples:
      | what           |
      | hang           |
      | hangInPercepts |

  @verify
  Scenario: a sketch waits in its loop(): its agent is told so, and gets its percepts nevertheless
    Given a robot with SlowLoop
    When 20 s pass
    Then the agent robot still believes celsius(21)
    And it has printed "the sketch's loop took": 2.0 s
    And it has printed "the board is off:": nothing

  Scenario: a board is reset: its agent sees it and goes on
    Given a robot with Vehicle, by the agent watcher, that senses {"type": "ldr", "pin": "A0", "light": [[0, 300]]}
    When robot's board is reset
    Then the agent robot prints "port off"
    And within 5 s it prints "light 300"
    And within 5 s it prints "answered"
    When an attacker sends tell hello(1) as CAFF
    Then it prints "message 1 from CAFF"
    And it has printed "port": on, off, on

  @verify
  Scenario: a board is unplugged and comes back: its agent sees it and goes on
    Given a robot with Vehicle, by the agent watcher, that senses {"type": "ldr", "pin": "A0", "light": [[0, 300]]}
    When robot's board is unplugged
    Then within 4 min the agent robot prints "port off"
    When robot's board is plugged in
    Then within 4 min the agent robot prints "light 300"
    And within 4 min it prints "answered"
    When an attacker sends tell hello(1) as CAFF
    Then within 4 min it prints "message 1 from CAFF"
    And it has printed "port": on, off, on
