package rasterlab.app.course;

import com.fasterxml.jackson.core.JsonProcessingException;
import com.fasterxml.jackson.databind.JsonNode;
import java.io.IOException;
import java.nio.file.DirectoryStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.HashMap;
import java.util.Map;
import java.util.Optional;
import rasterlab.app.course.Standing.Earned;
import rasterlab.app.outcome.Complaint;
import rasterlab.app.outcome.FileKind;
import rasterlab.app.outcome.FileToRead;
import rasterlab.app.outcome.KeptJson;
import rasterlab.app.outcome.WholeFile;
import rasterlab.exercises.score.ScorePoints;

/**
 * The most points of what was tried on this computer, in a file beside what was said to the last
 * try: {@code ID.best.json} beside {@code ID.result.json}, and {@code ID.2.best.json} of a second
 * window.
 */
public final class LocalTries {
    private static final String RESULT = ".result.json";
    private static final String BEST = ".best.json";

    private LocalTries() {}

    /**
     * Notes the points of a try where they are more than before.
     *
     * @param result the file of what was said to it
     * @throws Complaint if they cannot be written
     */
    public static void note(Path result, ScorePoints points) {
        String name = result.getFileName().toString();
        Path file =
                result.resolveSibling(name.substring(0, name.length() - RESULT.length()) + BEST);
        Earned earned = new Earned(points.total(), points.of());
        if (earned(file).filter(best -> !earned.exceeds(best)).isPresent()) return;
        try {
            WholeFile.write(file, KeptJson.MAPPER.writeValueAsBytes(earned));
        } catch (JsonProcessingException e) {
            throw new AssertionError("two numbers", e);
        }
    }

    /**
     * The best of each exercise that was tried, of all windows; a last result serves where an
     * earlier version of the window kept no best one.
     */
    static Map<String, Standing> in(Path folder) throws IOException {
        var bests = new HashMap<String, Earned>();
        if (Files.isDirectory(folder)) {
            read(folder, BEST, bests);
            var lasts = new HashMap<String, Earned>();
            read(folder, RESULT, lasts);
            lasts.forEach(bests::putIfAbsent);
        }
        var standings = new HashMap<String, Standing>();
        bests.forEach((exercise, best) -> standings.put(exercise, Standing.graded(best)));
        return standings;
    }

    private static void read(Path folder, String ending, Map<String, Earned> bests)
            throws IOException {
        try (DirectoryStream<Path> files = Files.newDirectoryStream(folder, "*" + ending)) {
            for (Path file : files) {
                String name = file.getFileName().toString();
                String exercise = name.substring(0, name.indexOf('.'));
                earned(file)
                        .ifPresent(
                                found ->
                                        bests.merge(
                                                exercise,
                                                found,
                                                (one, other) -> other.exceeds(one) ? other : one));
            }
        }
    }

    /** The points that a file tells; empty where it tells none, as after a crash. */
    private static Optional<Earned> earned(Path file) {
        if (FileToRead.obstacle(file, FileKind.RESULT).isPresent()) return Optional.empty();
        try {
            JsonNode told = KeptJson.MAPPER.readTree(Files.readAllBytes(file));
            JsonNode parts = told.path("outcome").path("points");
            Earned earned =
                    parts.isObject()
                            ? new Earned(
                                    parts.path("accuracy").asInt()
                                            + parts.path("stability").asInt()
                                            + parts.path("speed").asInt(),
                                    parts.path("of").asInt())
                            : new Earned(told.path("points").asInt(), told.path("of").asInt());
            return Optional.of(earned).filter(one -> one.points() >= 0 && one.of() > 0);
        } catch (IOException unreadable) {
            return Optional.empty();
        }
    }
}
