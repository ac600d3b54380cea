# gradle test plays these scenarios, each from the start, on the emulated board, and checks them.
# docs/reference.md in Javino's folder lists all steps.
Feature: a lamp for the dark

  # The lamp has flashed at the start; the scenario goes on when that is over.
  Scenario: it gets dark
    Given within 1 s robot's lamp is off
    When the light at robot's A0 falls to 150
    Then within 500 ms robot's lamp is on
    And within 1 s the agent robot believes lamp(on)
    And it prints "my lamp is on"
    When the light at robot's A0 falls to 100
    Then not within 1 s it performs lampOn

  # The sensor trembles (board.json: noise); the sketch does not tell that.
  Scenario: the light stays
    Then within 3 s the agent robot believes light(_) at most 5 a second
    And not within 3 s the counter perceptsLeftOut of it rises

  Scenario: the cable comes off
    When robot's board is unplugged for 2 s
    Then the agent robot believes port("ports/robot", off)
    And within 1 s of its return it believes port("ports/robot", on)
@armScenario@