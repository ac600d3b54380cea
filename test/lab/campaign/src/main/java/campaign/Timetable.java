package campaign;

/** Has things happen at times of the boards. */
interface Timetable {

    /** Emulated seconds. */
    double now();

    /** Has something done at an emulated time. */
    void at(double second, Runnable what);
}
