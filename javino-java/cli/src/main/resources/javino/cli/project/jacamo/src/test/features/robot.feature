# gradle test plays these scenarios, each from the start, on the emulated board and in real time, and checks them.
# What is to happen within a time has three times as long. docs/reference.md in Javino's folder lists all steps.
Feature: a diary of the night

  # The lamp has flashed at the start; the scenario goes on when that is over.
  Scenario: dusk and dawn
    Given within 1 s robot's lamp is off
    When the light at robot's A0 falls to 150
    Then within 1 s robot's lamp is on
    And within 1 s the agent robot believes lamp(on)
    And within 2 s the agent teller believes entry(1, "dusk")
    When the light at robot's A0 rises to 700
    Then within 1 s robot's lamp is off
    And within 2 s the agent teller prints "the night has 2 entries"

  Scenario: the cable comes off
    When robot's board is unplugged for 2 s
    Then the agent robot believes port("ports/robot", off)
    And within 1 s of its return it believes port("ports/robot", on)
@armScenario@