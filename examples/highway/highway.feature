Feature: the highway
  The rescue of the paper's section 5. The launcher begins it, and all scenarios look at the one run.
  A board and its agent have one name.

  Scenario: Bus ROMA: has a collision: stops, alarms, broadcasts tell help
    Then within 5 min the agent bus prints "I have suffered an accident!!!"
    And within 5 min bus's motor is on
    And within 5 min its motor is off
    And within 5 min its buzzer is on
    And within 5 min its board broadcasts tell help

  Scenario: Police SUPO: hears it, multicasts someoneNeedHelp to //SU
    Then within 5 min the agent police prints "I got an accident message from ROMA. Requesting support!"
    And within 5 min police's board sends a sealed message to //SU

  Scenario: Support SUPP: hears that, unicasts someoneNeedHelp to SUHO
    Then within 5 min the agent support prints a line with "I got a help message in the public safety group"
    And within 5 min support's board sends a sealed message to SUHO

  Scenario: Hospital SUHO: hears that, unicasts someoneNeedAmbulance to SUAM
    Then within 5 min the agent hospital prints "Asking for an ambulance!!!"
    And within 5 min hospital's board sends a sealed message to SUAM

  Scenario: Ambulance SUAM: hears that, drives with siren, unicasts ambulanceIsComing to SUHO
    Then within 5 min the agent ambulance prints "I am going!!!"
    And within 5 min ambulance's siren is on
    And within 5 min its motor is on
    And within 5 min its board sends a sealed message to SUHO

  Scenario: Hospital SUHO: unicasts ambulanceIsComing to SUPP
    Then within 5 min the agent hospital prints "Sending an Ambulance!"
    And within 5 min hospital's board sends a sealed message to SUPP

  Scenario: Support SUPP: unicasts helpComing to SUPO
    Then within 5 min the agent support prints "I understood! The Ambulance is coming!"
    And within 5 min support's board sends a sealed message to SUPO

  Scenario: Police SUPO: unicasts helpComing to ROMA
    Then within 5 min the agent police prints "The help is coming!"
    And within 5 min police's board sends a sealed message to ROMA

  Scenario: Bus ROMA: hears it: help is coming
    Then within 5 min the agent bus prints "Help is coming, says SUPO"
