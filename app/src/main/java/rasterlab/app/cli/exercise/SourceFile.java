package rasterlab.app.cli.exercise;

import java.nio.file.Path;
import rasterlab.app.outcome.Complaint;
import rasterlab.app.outcome.FileKind;
import rasterlab.app.outcome.FileToRead;

/** Reads a student's source. */
public final class SourceFile {
    private SourceFile() {}

    /**
     * The text of the file.
     *
     * @throws Complaint if there is no file, or it is empty, too long, or not UTF-8
     */
    public static String read(Path file) {
        String source = FileToRead.text(file, FileKind.SOURCE);
        if (source.isEmpty()) throw Complaint.badInput(file + ": is empty");
        return source;
    }
}
