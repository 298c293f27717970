package rasterlab.app.outcome;

import java.io.IOException;
import java.nio.file.AccessDeniedException;
import java.nio.file.AccessMode;
import java.nio.file.Files;
import java.nio.file.Path;

/** Tells before a file is opened why it cannot be read. */
public final class FileToRead {
    private FileToRead() {}

    /**
     * Passes if the file is there and may be read.
     *
     * @param kind what it should be, such as "a picture"
     * @throws Complaint if it is a folder, is not there, or the user has no right to read it
     */
    public static void require(Path file, String kind) {
        if (Files.isDirectory(file)) throw Complaint.badInput(file + ": is a folder, not " + kind);
        try {
            file.getFileSystem().provider().checkAccess(file, AccessMode.READ);
        } catch (AccessDeniedException e) {
            throw Complaint.badInput(file + ": no right to read it");
        } catch (IOException e) {
            throw Complaint.badInput(file + ": no such file to read");
        }
    }
}
