// Behaviour an agent can count on with a board. Each +!test_… runs in an agent of its own, whose board perceives p(1)
// and p(-2), knows no action fly, refuses jump, has no key for NOKE, hears "tell;q(7)" from ROMA, and delivers all.

+!test_port_isBelieved
    <- ?port("desk", on)[source(percept)].

+!test_percepts_opened_areBelieved
    <- .percepts(open);
       .wait(p(1)[source(percept)] & p(X) & X < 0, 5000).

+!test_percepts_blocked_areForgottenButThePortIsNot
    <- .percepts(open);
       .wait(p(1), 5000);
       .percepts(block);
       .wait(not p(_), 5000);
       ?port("desk", on).

+!test_limit_set_perceptsStillCome
    <- .limit(1);
       .percepts(open);
       .wait(p(1), 5000).

+!test_messages_opened_senderCanBeAnswered
    <- .getRFMessages(open);
       .wait(q(7), 5000);
       ?q(7)[source(S)];
       .term2string(S, "ROMA");
       .diffuse(S, tell, thanks);
       .send(S, achieve, go(1)).

+!test_openness_followsWhatIsThere
    <- ?openness(totallyClosed)[source(percept)];
       .infrastructure(lte, [mob]);
       .wait(openness(limitedOpen), 5000);
       .getRFMessages(open);
       .wait(openness(open), 5000);
       .infrastructure(lte, []);
       .wait(openness(closed), 5000);
       .getRFMessages(block);
       .wait(openness(totallyClosed), 5000).

+!test_act_unknownAction_errorCanBeMatched
    <- !attempt({ .act(fly) });
       ?failed(unknown_action).

+!test_act_refused_errorCanBeMatched
    <- !attempt({ .act(jump) });
       ?failed(action_failed).

+!test_act_plainUnknownAction_sameErrorCanBeMatched
    <- !attempt({ fly });
       ?failed(unknown_action).

+!test_diffuse_noKey_errorCanBeMatched
    <- !attempt({ .diffuse("NOKE", tell, secret) });
       ?failed(no_key).

+!test_diffuse_delivered_isAnEvent
    <- .diffuse("ROMA", tell, hello);
       .wait(heard(hello), 5000).

+delivered("ROMA", tell, What)[source(percept)] <- +heard(What).

+!test_deliver_delivered_goesOn
    <- .deliver("ROMA", tell, hello).

+!test_deliver_noKey_errorCanBeMatched
    <- !attempt({ .deliver("NOKE", tell, secret) });
       ?failed(no_key).

+!test_act_manyAtOnce_allArePerformed
    <- for (.range(I, 1, 20)) { .act(step(I)); };
       !step(1) |&| !step(2) |&| !step(3).

+!step(I) <- .act(step(I)).

+!attempt(Body) <- Body; .fail.
-!attempt(_)[error(unknown_action)] <- +failed(unknown_action).
-!attempt(_)[error(action_failed)]  <- +failed(action_failed).
-!attempt(_)[error(no_key)]         <- +failed(no_key).
