package uppaal.conformance;

/** A value that is known only to lie between two numbers. */
record Interval(double least, double most) {

    static final Interval ANY = new Interval(Double.NEGATIVE_INFINITY, Double.POSITIVE_INFINITY);
    static final Interval NEVER = of(Double.POSITIVE_INFINITY);

    static Interval of(double exact) {
        return new Interval(exact, exact);
    }

    boolean holds(double value) {
        return least <= value && value <= most;
    }

    Interval plus(Interval other) {
        return new Interval(least + other.least, most + other.most);
    }

    Interval minus(Interval other) {
        return new Interval(least - other.most, most - other.least);
    }

    Interval times(double factor) {
        return new Interval(least * factor, most * factor);
    }

    Interval atLeast(double floor) {
        return new Interval(Math.max(floor, least), Math.max(floor, most));
    }

    Interval atMost(double ceiling) {
        return new Interval(Math.min(ceiling, least), Math.min(ceiling, most));
    }
}
