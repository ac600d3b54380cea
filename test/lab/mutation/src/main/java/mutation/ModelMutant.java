package mutation;

/**
 * A model with one small change.
 *
 * @param place the place of the change, as a person finds it: template, edge or location, kind of the label
 * @param what the change
 * @param xml the whole file with it
 */
record ModelMutant(String place, String what, String xml) {
    @Override
    public String toString() {
        return place + ": " + what;
    }
}
