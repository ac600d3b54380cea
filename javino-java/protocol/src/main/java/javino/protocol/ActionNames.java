package javino.protocol;

import java.util.ArrayList;
import java.util.List;

/**
 * The names of a sketch's actions, as far as its board has told them (SPEC 4.3, list actions).
 *
 * @param count how many actions there are, 0…255.
 * @param told  their names from the first on, each closed by 0x00; the last may not be whole yet.
 */
public record ActionNames(int count, Bytes told) {

    static ActionNames decode(Bytes body) throws ProtocolException {
        Reply.expect(body.length() > 0, "the names of actions come with their number", body);
        return new ActionNames(body.at(0), body.from(1)).checked(body);
    }

    /**
     * These and what comes after them.
     *
     * @param next the reply to a request with the length of {@link #told} as its offset.
     * @throws ProtocolException BAD_REPLY if nothing comes, or more than there are actions.
     */
    public ActionNames and(ActionNames next) throws ProtocolException {
        Reply.expect(next.count == count && next.told.length() > 0, "all of " + count + " actions have names",
                next.told);
        return new ActionNames(count, Bytes.join(told, next.told)).checked(next.told);
    }

    private ActionNames checked(Bytes last) throws ProtocolException {
        int names = ends().size();
        boolean whole = told.length() == 0 || told.at(told.length() - 1) == 0;
        Reply.expect(names < count || names == count && whole, "no more than " + count + " actions have names", last);
        Reply.expect(told.length() <= Request.MAX_OFFSET, "the names of actions have an end", last);
        return this;
    }

    /** Whether all are there. */
    public boolean areAll() {
        return ends().size() == count;
    }

    /** The names that are there as a whole, in the sketch's order. */
    public List<String> names() throws ProtocolException {
        List<String> names = new ArrayList<>();
        int start = 0;
        for (int end : ends()) {
            names.add(told.slice(start, end).text());
            start = end + 1;
        }
        return List.copyOf(names);
    }

    private List<Integer> ends() {
        List<Integer> ends = new ArrayList<>();
        for (int at = 0; at < told.length(); at++) {
            if (told.at(at) == 0) {
                ends.add(at);
            }
        }
        return ends;
    }
}
