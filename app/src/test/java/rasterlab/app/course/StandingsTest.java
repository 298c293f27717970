package rasterlab.app.course;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.net.URI;
import java.nio.file.Path;
import java.time.Instant;
import java.util.Optional;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import rasterlab.app.course.Standing.Earned;
import rasterlab.app.course.Standing.StandingState;
import rasterlab.app.course.Standings.KnownStandings;
import rasterlab.app.course.Standings.Source;
import rasterlab.app.server.Account;
import rasterlab.app.server.CourseServer;
import rasterlab.app.server.FakeServer;
import rasterlab.exercises.score.ScorePoints;

class StandingsTest {
    private static final String LIST = "GET /api/v1/exercises";

    private final BlockingQueue<Runnable> events = new LinkedBlockingQueue<>();
    private final BlockingQueue<Throwable> failures = new LinkedBlockingQueue<>();
    private FakeServer server;
    private Standings standings;

    @TempDir Path drafts;

    @BeforeEach
    void open() throws IOException {
        server = new FakeServer();
        standings = new Standings(CourseServer.ServerTimeouts.USUAL, events::add, failures::add);
        standings.readFrom(drafts);
        LocalTries.note(drafts.resolve("circle.result.json"), new ScorePoints(9, 0, 0, 100));
    }

    @AfterEach
    void close() {
        standings.close();
        server.close();
        assertEquals(null, failures.peek());
    }

    @Test
    void triesHereCountBeforeACourseIsJoined() throws InterruptedException {
        KnownStandings told = look(Optional.empty());
        assertEquals(Source.HERE, told.source());
        assertEquals(new Earned(9, 100), told.of("circle").points().orElseThrow());
        assertEquals(Standing.NOT_TRIED, told.of("ellipse"));
    }

    @Test
    void serversWordCountsOnceACourseIsJoined() throws InterruptedException {
        server.on(
                LIST,
                200,
                """
                [{"id":"circle","state":"not-tried","best":null,"points":{"total":100},
                  "deadline":"2026-12-01T20:00:00.000Z"},
                 {"id":"ellipse","state":"graded","best":81,"points":{"total":100},
                  "deadline":null},
                 {"id":"color","state":"waiting","best":null,"points":{"total":100},
                  "deadline":null}]
                """);
        KnownStandings told = look(account());
        assertEquals(Source.SERVER, told.source());
        assertEquals(
                new Standing(
                        StandingState.NOT_TRIED,
                        Optional.empty(),
                        Optional.of(Instant.parse("2026-12-01T20:00:00Z"))),
                told.of("circle"));
        assertEquals(Standing.graded(new Earned(81, 100)), told.of("ellipse"));
        assertEquals(StandingState.WAITING, told.of("color").state());
    }

    @Test
    void triesHereCountWhereTheServerRefusesOrSaysNonsense() throws InterruptedException {
        KnownStandings refused = look(account());
        assertEquals(Source.HERE_SERVER_SILENT, refused.source());
        assertEquals(server.address(), refused.detail());
        assertEquals(new Earned(9, 100), refused.of("circle").points().orElseThrow());
        server.on(LIST, 200, "[{\"id\":\"circle\",\"state\":\"graded\",\"deadline\":\"soon\"}]");
        assertEquals(Source.HERE_SERVER_SILENT, look(account()).source());
    }

    private Optional<Account> account() {
        return Optional.of(new Account(URI.create(server.address()), "token", "Ada"));
    }

    private KnownStandings look(Optional<Account> account) throws InterruptedException {
        standings.look(account);
        Runnable event = events.poll(60, TimeUnit.SECONDS);
        assertTrue(event != null, "nothing is told");
        event.run();
        return standings.knownStandings();
    }
}
