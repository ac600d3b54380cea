// Publishes the light that it is told of by radio, for Home Assistant for example, and nothing else that it hears.

light_sensor("{\"name\": \"Light in the garden\", \"unique_id\": \"garden_light\", \"state_topic\": \"garden/light\"}").

!start.

+!start <-
    .port(ttyACM0);
    .setMyRFId("HOME");
    .getRFMessages(open);
    !announce.

+!announce : light_sensor(Description) <-
    mqtt.publish("homeassistant/sensor/garden_light/config", Description).

-!announce <- .wait(5000); !announce.             // the broker is not there

+light(L)[cast(unicast, _)] : .number(L) <-       // sealed: a broadcast could be forged
    .abolish(light(_));
    mqtt.publish("garden/light", L).
