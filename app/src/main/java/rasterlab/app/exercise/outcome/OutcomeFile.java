package rasterlab.app.exercise.outcome;

import com.fasterxml.jackson.core.JsonProcessingException;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Optional;
import rasterlab.app.outcome.Complaint;
import rasterlab.app.outcome.FileKind;
import rasterlab.app.outcome.FileToRead;
import rasterlab.app.outcome.KeptJson;
import rasterlab.app.outcome.WholeFile;
import rasterlab.exercises.Exercise;
import rasterlab.exercises.scene.SceneFile;

/**
 * The last outcome of a source, kept in a file beside it with the text that was tried, so that a
 * later change of the text is noticed.
 */
public final class OutcomeFile {
    /**
     * @param revision of the exercise at that time
     */
    private record Content(String revision, Outcome outcome) {}

    private OutcomeFile() {}

    /**
     * @throws Complaint if it cannot be written, or is longer than what is read
     */
    public static void write(Path file, Exercise exercise, Outcome outcome) {
        try {
            byte[] text =
                    KeptJson.MAPPER.writeValueAsBytes(new Content(exercise.revision(), outcome));
            if (text.length > FileKind.RESULT.most())
                throw Complaint.badInput(
                        "%s: cannot be written: would have %d bytes, %s has at most %d"
                                .formatted(
                                        file,
                                        text.length,
                                        FileKind.RESULT,
                                        FileKind.RESULT.most()));
            WholeFile.write(file, text);
        } catch (JsonProcessingException e) {
            throw new AssertionError("a record of texts and numbers", e);
        }
    }

    /**
     * The kept outcome; empty where there is none that can be used, or where it is of another
     * revision of the exercise: the next check says it anew.
     */
    public static Optional<Outcome> read(Path file, Exercise exercise) {
        if (FileToRead.obstacle(file, FileKind.RESULT).isPresent()) return Optional.empty();
        try {
            Content kept = KeptJson.MAPPER.readValue(Files.readAllBytes(file), Content.class);
            return Optional.ofNullable(kept)
                    .filter(one -> one.revision().equals(exercise.revision()))
                    .map(Content::outcome)
                    .filter(OutcomeFile::hasReadableScenes);
        } catch (IOException e) {
            return Optional.empty();
        }
    }

    private static boolean hasReadableScenes(Outcome outcome) {
        try {
            outcome.cases().stream()
                    .map(CaseResult::scene)
                    .filter(scene -> !scene.isEmpty())
                    .forEach(SceneFile::read);
            return true;
        } catch (IllegalArgumentException e) {
            return false;
        }
    }
}
