package javino.board;

import java.lang.reflect.Method;

/** Makes the threads of sessions: virtual ones where Java has them (21 and newer), so that a hundred cost little. */
final class SessionThread {

    private SessionThread() {
    }

    /** A daemon thread, not started yet. */
    static Thread of(String name, Runnable task) {
        try {
            Object builder = Thread.class.getMethod("ofVirtual").invoke(null);
            // The interface gives the methods, as the class behind it is not public.
            Class<?> type = Class.forName("java.lang.Thread$Builder");
            Method named = type.getMethod("name", String.class);
            return (Thread) type.getMethod("unstarted", Runnable.class).invoke(named.invoke(builder, name), task);
        } catch (ReflectiveOperationException e) {
            Thread thread = new Thread(task, name);
            thread.setDaemon(true);
            return thread;
        }
    }
}
