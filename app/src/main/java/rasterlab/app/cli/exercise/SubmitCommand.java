package rasterlab.app.cli.exercise;

import com.fasterxml.jackson.core.JsonGenerator;
import com.fasterxml.jackson.databind.JsonNode;
import java.io.IOException;
import java.net.URI;
import java.nio.file.Path;
import java.util.HashSet;
import java.util.Set;
import java.util.UUID;
import java.util.concurrent.Callable;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;
import rasterlab.app.cli.console.Console;
import rasterlab.app.cli.console.PrettyJson;
import rasterlab.app.outcome.Complaint;
import rasterlab.app.outcome.ExitCode;
import rasterlab.app.server.Account;
import rasterlab.app.server.Breakdown;
import rasterlab.app.server.CourseServer;
import rasterlab.app.server.Following;
import rasterlab.app.server.ServerRefusal;
import rasterlab.app.server.ServerReport;
import rasterlab.exercises.Exercise;
import rasterlab.exercises.catalogue.Catalogue;
import rasterlab.exercises.document.OwnJson;
import rasterlab.exercises.score.GradingVerdict;

/** Hands a solution in to a grading server and says what came of it. */
@Command(
        name = "submit",
        mixinStandardHelpOptions = true,
        description = {
            "Hands a solution in to a grading server, waits for the result and prints it.",
            "The token is best kept in a file or in RASTERLAB_TOKEN: others may see a command's words."
        },
        exitCodeListHeading = "%nExit codes:%n",
        exitCodeList = {
            "0:every case is right",
            "1:a case fails, or what was submitted was not accepted by the judge",
            "2:the file or the token cannot be read, or the server refuses them",
            "4:no server answers, or it accepts no more at the moment, or the connection was lost",
        },
        footer = {
            "",
            "Example: ./lab submit line-bresenham Bresenham.java --server http://localhost:8080"
                    + " --token-file token.txt"
        })
public final class SubmitCommand implements Callable<Integer> {
    private final Console console;

    @Parameters(index = "0", paramLabel = "EXERCISE", description = "such as line-bresenham")
    private String exercise;

    @Parameters(
            index = "1",
            paramLabel = "FILE",
            description = "your Java source; for an exercise of kind break your inputs as JSON")
    private Path file;

    @Option(
            names = "--server",
            paramLabel = "URL",
            required = true,
            description = "the grading server, such as http://localhost:8080")
    private String server;

    @Mixin private TokenOption token;

    @Option(
            names = "--late",
            description =
                    "submits after the deadline too: it is graded like any other attempt and marked"
                            + " as late, and loses the points that the course takes for that")
    private boolean late;

    @Option(names = "--json", description = "prints the server's document as it is")
    private boolean json;

    @Mixin private ExercisesOption exercises;

    public SubmitCommand(Console console) {
        this.console = console;
    }

    @Override
    public Integer call() throws IOException {
        Catalogue catalogue = exercises.catalogue(console);
        if (exercises.isGiven()) ExercisesOption.named(exercise, catalogue);
        if (!exercise.matches("[a-z0-9-]+"))
            throw Complaint.badInput("no exercise can be called '" + exercise + "'");
        URI address = address();
        String secret = token.read();
        String source = SourceFile.read(file);
        try {
            return handedIn(
                    new CourseServer(address, CourseServer.ServerTimeouts.USUAL),
                    secret,
                    source,
                    catalogue);
        } catch (ServerRefusal refusal) {
            throw refused(address, refusal);
        } catch (IOException broken) {
            throw brokenOff(address, broken);
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
            throw Complaint.gaveUp("interrupted");
        }
    }

    private int handedIn(CourseServer to, String secret, String source, Catalogue catalogue)
            throws IOException, InterruptedException {
        JsonNode asked = to.exercise(secret, exercise, language());
        String id =
                to.submit(
                        secret,
                        exercise,
                        Exercise.TaskKind.mediaType(asked.path("kind").asText()),
                        source,
                        UUID.randomUUID().toString(),
                        late);
        console.tell("submitted", id);
        warnOfOtherRevision(asked, catalogue);
        new Following(to, secret).toItsEnd(id, progress(catalogue));
        JsonNode result = to.submission(secret, id, language());
        if (json) print(result);
        else report().print(asked, ServerReport.read(result), result.path("late").asBoolean());
        return GradingVerdict.OK.code().equals(result.path("verdict").asText())
                ? ExitCode.DONE
                : ExitCode.FOUND_WRONG;
    }

    private ReportText report() {
        return new ReportText(
                console.out(), console.language().texts(), file.getFileName().toString());
    }

    private void print(JsonNode document) throws IOException {
        JsonGenerator out = PrettyJson.to(console.out());
        OwnJson.MAPPER.writeTree(out, document);
        out.writeRaw('\n');
        out.flush();
    }

    /** Where what is tried here is not what is graded there, a check may say something else. */
    private void warnOfOtherRevision(JsonNode asked, Catalogue catalogue) {
        if (!catalogue.ids().contains(exercise)) return;
        String there = asked.path("revision").asText();
        String here = catalogue.named(exercise).revision();
        if (!there.isEmpty() && !there.equals(here)) console.tell("other-revision", there, here);
    }

    private URI address() {
        try {
            return Account.server(server);
        } catch (IllegalArgumentException e) {
            throw Complaint.badInput(
                    "--server: '"
                            + server
                            + "' is not an address; it looks like http://localhost:8080");
        }
    }

    private static Complaint refused(URI address, ServerRefusal refusal) {
        int status = refusal.status();
        if (status == 401)
            return Complaint.badInput(
                    address
                            + " does not know the token: join the course again, or ask for a new one");
        if (refusal.code().equals(CourseServer.LATE))
            return Complaint.badInput(
                    address
                            + " takes it after the deadline with --late alone: it is graded like"
                            + " any other attempt, is marked as late and may cost points, as the"
                            + " exercise tells");
        String said =
                refusal.code().isEmpty()
                        ? address + " does not answer as a grading server (status " + status + ")"
                        : address
                                + " does not take it: "
                                + refusal.getMessage()
                                + " (status "
                                + status
                                + ")";
        boolean later = status == 429 || status >= 500;
        return later ? Complaint.gaveUp(said) : Complaint.badInput(said);
    }

    private static Complaint brokenOff(URI address, IOException broken) {
        return switch (Breakdown.of(broken)) {
            case DOWN ->
                    Complaint.gaveUp(
                            "no answer from "
                                    + address
                                    + ": is the address right and the server running?");
            case SLOW -> Complaint.gaveUp(address + " takes too long to answer");
            case LOST -> Complaint.gaveUp("the connection to " + address + " was lost");
            case OTHER ->
                    Complaint.gaveUp(
                            "the connection to " + address + " was lost: " + broken.getMessage());
        };
    }

    private String language() {
        return console.language().code();
    }

    /** Tells the turn, and the cases as they are judged, each once, but no verdict yet. */
    private Following.Follower progress(Catalogue catalogue) {
        Set<String> told = new HashSet<>();
        return new Following.Follower() {
            @Override
            public void waits(int position) {
                if (position > 0) console.tell("waits", position);
            }

            @Override
            public void judged(JsonNode one) {
                String name = one.path("name").asText();
                if (told.add(name)) console.tell("tried", title(catalogue, name, one));
            }
        };
    }

    /** The server tells titles on the way in English alone. */
    private String title(Catalogue catalogue, String name, JsonNode one) {
        return catalogue.ids().contains(exercise)
                ? catalogue.named(exercise).caseTitle(name, language())
                : one.path("title").asText(name);
    }
}
