package rasterlab.app.study;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Optional;
import rasterlab.app.mine.OwnMethods;
import rasterlab.app.outcome.Complaint;
import rasterlab.app.outcome.FileKind;
import rasterlab.app.outcome.FileToRead;
import rasterlab.app.outcome.WholeFile;
import rasterlab.engine.study.Study;
import rasterlab.engine.study.Topic;
import rasterlab.exercises.json.NotJson;

/** The last result of each topic, in a folder of the user's: a study as JSON for each. */
final class KeptStudies {
    private final Path folder;

    /**
     * @param folder made when the first result is kept
     */
    KeptStudies(Path folder) {
        this.folder = folder;
    }

    /**
     * Keeps a study in place of its topic's last one, but for the user's own program, which may be
     * another the next time.
     *
     * @throws Complaint if it cannot be written
     */
    void keep(Study study) {
        WholeFile.requireFolder(folder);
        WholeFile.write(file(study.topic()), StudyJson.of(withoutOwn(study)));
    }

    /** The study without the user's own program. */
    static Study withoutOwn(Study study) {
        return study.with(
                study.measurements().stream()
                        .filter(one -> !one.method().equals(OwnMethods.NAME))
                        .toList());
    }

    /**
     * The last result of that topic, of the methods and workloads that it still has; empty where
     * there is none.
     *
     * @throws Complaint if there is a file that is none
     */
    Optional<Study> read(Topic<?, ?, ?> topic) {
        Path file = file(topic.name());
        if (!Files.exists(file)) return Optional.empty();
        try {
            Study study = StudyReading.of(FileToRead.text(file, FileKind.RESULT), topic);
            return Optional.of(study).filter(one -> !one.measurements().isEmpty());
        } catch (NotJson e) {
            throw Complaint.badInput(file + ": cannot be read: not JSON: " + e.phrase());
        } catch (IllegalArgumentException e) {
            throw Complaint.badInput(file + ": cannot be read: " + e.getMessage());
        }
    }

    private Path file(String topic) {
        return folder.resolve(topic + ".json");
    }
}
