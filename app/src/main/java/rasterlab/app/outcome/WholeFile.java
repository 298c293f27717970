package rasterlab.app.outcome;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.nio.file.StandardOpenOption;

/** Writes files that are there whole or not at all, whenever the program is stopped. */
public final class WholeFile {
    private WholeFile() {}

    /**
     * Writes under another name in the same folder, then moves.
     *
     * @throws Complaint if the file cannot be written
     */
    public static void write(Path target, byte[] content) {
        Path unfinished =
                folder(target)
                        .resolve(
                                "."
                                        + target.getFileName()
                                        + "."
                                        + ProcessHandle.current().pid()
                                        + ".part");
        unfinished.toFile().deleteOnExit();
        try {
            Files.write(unfinished, content, StandardOpenOption.CREATE_NEW);
            Files.move(unfinished, target, StandardCopyOption.REPLACE_EXISTING);
        } catch (IOException e) {
            throw Complaint.badInput(target + ": cannot be written: " + reason(e));
        } finally {
            unfinished.toFile().delete();
        }
    }

    /**
     * Passes if the file can probably be written, before long work is begun.
     *
     * @throws Complaint saying what is in the way
     */
    public static void requireWritable(Path target) {
        Path folder = folder(target);
        if (!Files.isDirectory(folder))
            throw Complaint.badInput(target + ": cannot be written: no folder " + folder);
        if (Files.isDirectory(target))
            throw Complaint.badInput(target + ": cannot be written: it is a folder");
        if (!Files.isWritable(folder))
            throw Complaint.badInput(
                    target + ": cannot be written: no right to write in " + folder);
    }

    /**
     * Makes the folder where it is missing.
     *
     * @throws Complaint if it cannot be made or written to
     */
    public static void requireFolder(Path folder) {
        try {
            Files.createDirectories(folder);
        } catch (IOException e) {
            throw Complaint.badInput(folder + ": cannot be made a folder: " + reason(e));
        }
        if (!Files.isWritable(folder))
            throw Complaint.badInput(folder + ": no right to write there");
    }

    /** What a file error means, without the path that the message already has. */
    public static String reason(IOException e) {
        return switch (e.getClass().getSimpleName()) {
            case "NoSuchFileException" -> "no such file";
            case "AccessDeniedException" -> "no right to";
            case "FileAlreadyExistsException" -> "a file of that name is in the way";
            default -> String.valueOf(e.getMessage());
        };
    }

    private static Path folder(Path target) {
        return target.toAbsolutePath().getParent();
    }
}
