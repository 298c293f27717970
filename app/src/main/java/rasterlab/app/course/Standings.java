package rasterlab.app.course;

import com.fasterxml.jackson.databind.JsonNode;
import java.io.IOException;
import java.nio.file.Path;
import java.time.Instant;
import java.time.format.DateTimeParseException;
import java.util.HashMap;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.Executor;
import java.util.function.Consumer;
import rasterlab.app.canvas.work.Background;
import rasterlab.app.canvas.work.Listeners;
import rasterlab.app.course.Standing.Earned;
import rasterlab.app.course.Standing.StandingState;
import rasterlab.app.outcome.WholeFile;
import rasterlab.app.server.Account;
import rasterlab.app.server.CourseServer;

/**
 * How far the student has come: as the server of the course tells a student who joined one, else by
 * what was tried on this computer. Used on the thread of the executor; reads on one of its own.
 */
public final class Standings implements AutoCloseable {
    /**
     * All that is known of the standings.
     *
     * @param exercises those that were tried, by id
     * @param detail the server where the student has joined a course, or why nothing can be read;
     *     "" where there is nothing to say
     */
    record KnownStandings(Map<String, Standing> exercises, Source source, String detail) {
        Standing of(String exercise) {
            return exercises.getOrDefault(exercise, Standing.NOT_TRIED);
        }
    }

    enum Source {
        HERE,
        SERVER,
        /** Tries on this computer, since the server does not tell. */
        HERE_SERVER_SILENT,
        /** No source: what was kept here cannot be read. */
        UNREADABLE
    }

    private final CourseServer.ServerTimeouts patience;
    private final Background background;
    private final Listeners<KnownStandings> listeners = new Listeners<>();
    private Optional<Path> folder = Optional.empty();
    private KnownStandings told = new KnownStandings(Map.of(), Source.HERE, "");

    /**
     * @param events runs what it is given on the one thread that uses this, in order
     * @param onFailure told what reading threw, on any thread
     */
    public Standings(
            CourseServer.ServerTimeouts patience, Executor events, Consumer<Throwable> onFailure) {
        this.patience = patience;
        background = new Background("course map", events, onFailure);
    }

    /** Finds tries of this computer in that folder. */
    public void readFrom(Path folder) {
        this.folder = Optional.of(folder);
    }

    KnownStandings knownStandings() {
        return told;
    }

    Runnable listen(Consumer<KnownStandings> listener) {
        return listeners.add(listener);
    }

    /** Looks anew; tells at once what is known here, and what the server knows when it answers. */
    public void look(Optional<Account> account) {
        background.begin(
                tell -> {
                    Map<String, Standing> here = here();
                    if (account.isEmpty())
                        return () -> publish(new KnownStandings(here, Source.HERE, ""));
                    String server = account.get().toString();
                    try {
                        Map<String, Standing> there = there(account.get());
                        return () -> publish(new KnownStandings(there, Source.SERVER, server));
                    } catch (IOException silent) {
                        return () ->
                                publish(
                                        new KnownStandings(
                                                here, Source.HERE_SERVER_SILENT, server));
                    }
                },
                () -> {},
                failure ->
                        publish(
                                new KnownStandings(
                                        Map.of(), Source.UNREADABLE, WholeFile.reason(failure))));
    }

    private void publish(KnownStandings next) {
        told = next;
        listeners.tell(next);
    }

    private Map<String, Standing> here() throws IOException {
        return folder.isPresent() ? LocalTries.in(folder.get()) : Map.of();
    }

    private Map<String, Standing> there(Account account) throws IOException, InterruptedException {
        var standings = new HashMap<String, Standing>();
        JsonNode list = new CourseServer(account.server(), patience).exercises(account.token());
        for (JsonNode one : list) standings.put(one.path("id").asText(), standing(one));
        return standings;
    }

    private static Standing standing(JsonNode one) throws IOException {
        Optional<Instant> deadline = deadline(one.path("deadline"));
        return switch (one.path("state").asText()) {
            case "graded" ->
                    new Standing(
                            StandingState.GRADED,
                            Optional.of(
                                    new Earned(
                                            one.path("best").asInt(),
                                            one.path("points").path("total").asInt())),
                            deadline);
            case "waiting" -> new Standing(StandingState.WAITING, Optional.empty(), deadline);
            default -> new Standing(StandingState.NOT_TRIED, Optional.empty(), deadline);
        };
    }

    private static Optional<Instant> deadline(JsonNode told) throws IOException {
        if (!told.isTextual()) return Optional.empty();
        try {
            return Optional.of(Instant.parse(told.asText()));
        } catch (DateTimeParseException e) {
            throw new IOException("the server's deadline is '" + told.asText() + "'", e);
        }
    }

    @Override
    public void close() {
        background.close();
    }
}
