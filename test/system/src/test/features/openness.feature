Feature: an agent knows how open its MAS is, by the radio of its board

  @verify
  Scenario: the board goes and comes: the agent goes through all transitions of figure 1
    Given a robot with Vehicle, by the agent wanderer
    When 20 s pass
    Then the agent robot still believes openness(open)
    When robot's board is unplugged
    Then within 4 min the agent robot no longer believes openness(totallyClosed)
    When robot's board is plugged in
    Then within 4 min the agent robot believes openness(closed)
    When robot's board is unplugged
    Then within 4 min the agent robot prints "openness totallyClosed"
    And it has printed "openness": totallyClosed, closed, open, limitedOpen, totallyClosed, limitedOpen, open, closed, totallyClosed

  Scenario: the radio opens and a plan admits: the agent sees the four kinds of table 1
    Given a robot with Vehicle, by the agent harbour
    Then the agent robot still believes openness(limitedOpen)
    And it has printed "openness": totallyClosed, closed, open, totallyClosed, limitedOpen

  Scenario: the radio hears nobody, and then a packet for another
    Given a robot with Vehicle, by the agent listener
    When 5 s pass
    And an attacker sends the packet ROMACAFFBotell;hello(1)
    Then within 10 s the agent robot believes openness(closed)
    And within 10 s it believes openness(totallyClosed)
    And it has printed "openness": totallyClosed, closed, totallyClosed, closed, totallyClosed
