package rasterlab.app.server;

import com.fasterxml.jackson.databind.JsonNode;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.util.Optional;

/** Follows submissions by the server's events until they have a result. */
public final class Following {
    /** Connections that may break off, one after the other, before that is told. */
    private static final int MOST_BREAKS = 3;

    /** Hears how a submission gets on, on the thread that follows it. */
    public interface Follower {
        /** Called at the beginning, and again whenever everything is told once more. */
        default void begins() {}

        /**
         * Called with the submission's turn.
         *
         * @param position in the queue, 1 being the next, 0 when its turn has come
         */
        void waits(int position);

        /**
         * Called with each case.
         *
         * @param one as the server publishes it
         */
        void judged(JsonNode one);
    }

    private final CourseServer server;
    private final String token;

    public Following(CourseServer server, String token) {
        this.server = server;
        this.token = token;
    }

    /** Waits for the result of that submission. */
    public void toItsEnd(String id, Follower follower) throws IOException, InterruptedException {
        for (int left = MOST_BREAKS; !followed(id, follower); left--)
            if (left == 0) throw new IOException("the events of submission " + id + " break off");
    }

    /** Follows the events; false where they ended before the submission did. */
    private boolean followed(String id, Follower follower)
            throws IOException, InterruptedException {
        follower.begins();
        try (EventLines events = server.events(token, id)) {
            for (Optional<EventLines.Event> next = events.next();
                    next.isPresent();
                    next = events.next()) {
                byte[] told = next.get().data().getBytes(StandardCharsets.UTF_8);
                JsonNode data = server.tree(told);
                switch (next.get().type()) {
                    case "position" -> follower.waits(data.path("position").asInt());
                    case "case" -> follower.judged(data);
                    case "done" -> {
                        return true;
                    }
                    default -> {}
                }
            }
        }
        return !server.submission(token, id, "en").path("verdict").isNull();
    }
}
