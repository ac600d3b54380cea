package javino.protocol;

import com.google.gson.JsonArray;
import com.google.gson.JsonElement;
import com.google.gson.JsonNull;
import com.google.gson.JsonObject;
import com.google.gson.JsonPrimitive;
import java.util.OptionalInt;

/** Replies in the form of the vectors. */
final class ReplyFields {

    private ReplyFields() {
    }

    /** The fields of the reply to a command, in the form of the vectors. */
    static JsonObject read(String name, Reply reply) throws ProtocolException {
        JsonObject fields = new JsonObject();
        switch (name) {
            case "hello" -> {
                BoardInfo info = reply.boardInfo();
                fields.addProperty("version", info.protocolVersion());
                fields.add("rfId", info.rfId().<JsonElement>map(id -> new JsonPrimitive(id.toString()))
                        .orElse(JsonNull.INSTANCE));
                fields.addProperty("bootEpoch", info.bootEpoch());
                fields.addProperty("radio", info.hasRadio());
                fields.addProperty("memory", info.capabilities().contains(Capability.MEMORY));
                fields.addProperty("unicastsOnly", info.hasUnicastsOnly());
                fields.addProperty("earlier", info.isOfEarlierLibrary());
                fields.addProperty("firmware", info.firmware());
            }
            case "poll" -> {
                PollReply poll = reply.poll();
                fields.addProperty("more", poll.more());
                fields.addProperty("leftOut", poll.leftOut());
                fields.addProperty("reading", poll.reading());
                fields.addProperty("damaged", poll.damaged());
                fields.addProperty("takenTimer", poll.takenTimer().isPresent() ? poll.takenTimer().getAsInt() : null);
                JsonArray records = new JsonArray();
                for (PollReply.Item item : poll.records()) {
                    records.add(describe(item));
                }
                fields.add("records", records);
            }
            case "act" -> {
                OptionalInt number = reply.number();
                fields.addProperty("number", number.isPresent() ? number.getAsInt() : null);
            }
            case "listActions" -> {
                ActionNames actions = reply.actionNames();
                fields.addProperty("count", actions.count());
                fields.addProperty("told", actions.told().hex());
                fields.addProperty("all", actions.areAll());
                JsonArray names = new JsonArray();
                actions.names().forEach(names::add);
                fields.add("names", names);
            }
            case "setKey", "renewKey", "setSessionKey" -> fields.addProperty("check", reply.checkValue().hex());
            case "listKeys" -> {
                JsonArray keys = new JsonArray();
                for (Reply.StoredKey key : reply.storedKeys()) {
                    JsonObject entry = new JsonObject();
                    entry.addProperty("address", key.address().toString());
                    entry.addProperty("role", key.role().ordinal() + (key.doubtful() ? 4 : 0));
                    entry.addProperty("check", key.check().hex());
                    keys.add(entry);
                }
                fields.add("keys", keys);
            }
            case "statistics" -> {
                JsonObject counters = new JsonObject();
                reply.statistics().forEach((counter, value) -> counters.addProperty(counter.toString(), value));
                fields.add("counters", counters);
            }
            case "relaying", "isRelaying" -> fields.addProperty("on", reply.relaying());
            case "transmit", "relay" -> fields.addProperty("number", reply.transmissionNumber());
            default -> reply.nothing();
        }
        return fields;
    }

    private static JsonObject describe(PollReply.Item item) throws ProtocolException {
        JsonObject described = new JsonObject();
        if (item instanceof PollReply.Percept percept) {
            described.addProperty("type", "percept");
            described.addProperty("literal", percept.literal().text());
        } else if (item instanceof PollReply.Transmission transmission) {
            described.addProperty("type", "transmission");
            described.addProperty("number", transmission.number());
            described.addProperty("outcome", transmission.outcome().ordinal());
        } else if (item instanceof PollReply.Message message) {
            described.addProperty("type", "message");
            described.addProperty("number", message.number());
            described.addProperty("destination", message.destination().toString());
            described.addProperty("origin", message.origin().toString());
            described.addProperty("id", message.id());
            described.addProperty("content", Content.decode(message.content()).toString());
        } else if (item instanceof PollReply.NoKey frame) {
            described.addProperty("type", "noKey");
            described.addProperty("destination", frame.destination().toString());
            described.addProperty("origin", frame.origin().toString());
        } else if (item instanceof PollReply.Overheard packet) {
            described.addProperty("type", "overheard");
            described.addProperty("millis", packet.millis());
            described.addProperty("how", packet.how().ordinal());
            described.addProperty("payload", packet.payload().hex());
        }
        return described;
    }
}
