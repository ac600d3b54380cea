Feature: an inspector travels meanwhile

  Scenario: Support SUPP: its inspector leaves for the bus
    Then within 5 min the agent inspector prints "I travel to ROMA"
    And within 5 min support's board sends a sealed message to ROMA

  Scenario: Bus ROMA: lets it in; it looks, and goes home
    Then within 5 min the agent bus prints "Welcome, inspector from SUPP"
    And within 5 min the agent inspector prints a line with "On ROMA I see an obstacle"
    And within 5 min bus's board sends a sealed message to SUPP

  Scenario: Support SUPP: has its inspector back, with what it saw
    Then within 5 min the agent inspector prints a line with "I am back from ROMA"
