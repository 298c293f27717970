package rasterlab.app.exercise;

import java.io.IOException;
import java.net.URI;
import rasterlab.app.exercise.JoinAnswer.JoinField;
import rasterlab.app.exercise.outcome.Notice;
import rasterlab.app.server.Breakdown;
import rasterlab.app.server.CourseServer;
import rasterlab.app.server.ServerRefusal;

/** Tells the user what a failed request to a server means. */
final class ServerNotices {
    private static final int UNAUTHORIZED = 401;
    private static final int TOO_MANY = 429;

    private ServerNotices() {}

    /** The notice of a source that could not be handed in. */
    static Notice of(URI server, IOException failure) {
        if (failure instanceof UnreadableSheet sheet) return sheet.notice();
        return failureNotice("server", server, failure);
    }

    /** The notice of a hint that was not given. */
    static Notice hints(URI server, IOException failure) {
        if (failure instanceof ServerRefusal refusal)
            switch (refusal.code()) {
                case "no-more-hints":
                    return Notice.of("hints.none");
                case "unknown-exercise":
                    return Notice.of("hints.unknown", server.toString());
                default:
                    return refused(server.toString(), refusal);
            }
        return failureNotice("hints", server, failure);
    }

    /** The answer to joining a course: what of the form is to be typed anew, and why. */
    static JoinAnswer joining(URI server, IOException failure) {
        String address = server.toString();
        if (failure instanceof ServerRefusal refusal) {
            if (refusal.status() == UNAUTHORIZED)
                return JoinAnswer.refused(JoinField.TOKEN, Notice.of("join.token", address));
            if (refusal.code().equals("unknown-course"))
                return JoinAnswer.refused(JoinField.CODE, Notice.of("join.code", address));
            if (refusal.code().equals("bad-name"))
                return JoinAnswer.refused(JoinField.NAME, Notice.of("join.name", address));
        }
        return JoinAnswer.refused(JoinField.ADDRESS, failureNotice("join", server, failure));
    }

    /**
     * @param talk begins the keys of what is said of a talk that was not finished
     */
    private static Notice failureNotice(String talk, URI server, IOException failure) {
        String address = server.toString();
        if (failure instanceof ServerRefusal refusal) return refused(address, refusal);
        return switch (Breakdown.of(failure)) {
            case DOWN -> Notice.of(talk + ".down", address);
            case SLOW -> Notice.of(talk + ".slow", address);
            case LOST -> Notice.of(talk + ".lost", address);
            case OTHER -> {
                String reason = failure.getMessage();
                yield Notice.of(
                        talk + ".failed", address, reason == null ? failure.toString() : reason);
            }
        };
    }

    private static Notice refused(String address, ServerRefusal refusal) {
        if (refusal.code().equals(CourseServer.LATE)) return Notice.of(CourseServer.LATE);
        if (refusal.code().startsWith(CourseServer.LATE))
            return Notice.of(CourseServer.LATE + ".said", refusal.getMessage());
        return switch (refusal.status()) {
            case UNAUTHORIZED -> Notice.of("server.token", address);
            case TOO_MANY -> Notice.of("server.tooMany", refusal.getMessage());
            default ->
                    Notice.of(
                            "server.refused",
                            address,
                            refusal.getMessage(),
                            String.valueOf(refusal.status()));
        };
    }
}
