package rasterlab.app.cli;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.charset.CharacterCodingException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import rasterlab.app.outcome.Complaint;
import rasterlab.app.outcome.WholeFile;
import rasterlab.exercises.Grading;

/** Reads a student's source. */
final class SourceFile {
    private SourceFile() {}

    /**
     * The text of the file.
     *
     * @throws Complaint if there is no file, or it is empty, too long, or not UTF-8
     */
    static String read(Path file) {
        if (Files.isDirectory(file)) throw Complaint.badInput(file + ": is a folder, not a file");
        try {
            long size = Files.size(file);
            if (size == 0) throw Complaint.badInput(file + ": is empty");
            if (size > Grading.MOST_SOURCE_BYTES)
                throw Complaint.badInput(
                        file
                                + ": has "
                                + size
                                + " bytes, the most for a source is "
                                + Grading.MOST_SOURCE_BYTES);
            return decoded(file, Files.readAllBytes(file));
        } catch (IOException e) {
            throw Complaint.badInput(file + ": cannot be read: " + WholeFile.reason(e));
        }
    }

    private static String decoded(Path file, byte[] bytes) {
        try {
            return StandardCharsets.UTF_8.newDecoder().decode(ByteBuffer.wrap(bytes)).toString();
        } catch (CharacterCodingException e) {
            throw Complaint.badInput(file + ": is not UTF-8 text");
        }
    }
}
