Feature: the library's examples that no test in Java uses

  Scenario Outline: the thermometer tells degrees, on a board of each supply
    Given a robot with Thermometer on a <board>, that senses {"type": "ldr", "pin": "A0", "light": [[0, <reading>]]}
    Then the agent robot still believes celsius(<degrees>)

    Examples: 747 mV of 5 V, 400 mV, 748 mV of 3.3 V
      | board   | reading | degrees |
      | mega    | 153     | 24.71   |
      | uno     | 82      | -9.96   |
      | promini | 232     | 24.77   |

  Scenario: a press of a twentieth of a second is told
    Given a robot with Button on an uno, that senses {"type": "digital", "pin": 2, "level": [[0, 1]]}
    When the button at robot's 2 is pressed for 50 ms
    Then the agent robot believes pressed
    And it no longer believes pressed
    When the button at robot's 2 is pressed for 50 ms
    Then the agent robot believes pressed
    And it no longer believes pressed

  Scenario Outline: a servo turns as far as the agent says, and no further than it can
    Given a robot with Servo on an uno
    Then the agent robot still believes angle(90)
    When the agent robot gets the goal do(turn(180))
    Then it believes angle(180)
    And within 1 s the servo at robot's pin 9 is at 180 degrees
    When the agent robot gets the goal do(<wrong>)
    Then it fails to perform <wrong> with action_failed

    Examples:
      | wrong      |
      | turn       |
      | turn(181)  |
      | turn(-1)   |
      | turn(half) |

  Scenario: a stepper turns at its speed while its agent is told
    Given a robot with Stepper on an uno
    When the agent robot gets the goal do(turn(3000))
    Then within 2.11 s robot's pin 3 is on exactly 3000 times
    And within 2.11 s robot's pin 3 is on at most 1575 a second
    And within 5 s the agent robot believes position(3000)
    When the agent robot gets the goal do(turn(-3000))
    Then within 3 s it believes position(0)

  Scenario: an Uno senses and acts
    Given a robot with RadioBlink on an uno
    Then the agent robot still believes led(off)
    When the agent robot gets the goal do(ledOn)
    Then within 1 s robot's 13 is on
    And it believes led(on)
