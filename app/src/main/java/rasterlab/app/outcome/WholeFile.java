package rasterlab.app.outcome;

import java.io.IOException;
import java.nio.file.FileSystemException;
import java.nio.file.Files;
import java.nio.file.LinkOption;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.nio.file.StandardOpenOption;

/** Writes files that are there whole or not at all, whenever the program is stopped. */
public final class WholeFile {
    private WholeFile() {}

    /**
     * Writes under another name in the same folder, then takes the target's place in one step.
     *
     * @throws Complaint if the file cannot be written
     */
    public static void write(Path target, byte[] content) {
        Path unfinished = unfinished(target);
        unfinished.toFile().deleteOnExit();
        try {
            Files.write(unfinished, content, StandardOpenOption.CREATE_NEW);
            Files.move(unfinished, target, StandardCopyOption.ATOMIC_MOVE);
        } catch (IOException e) {
            throw cannotWrite(target, reason(e));
        } finally {
            unfinished.toFile().delete();
        }
    }

    /**
     * Passes if the file can be written, which is tried beside it before long work is begun: rights
     * alone do not tell, because not every folder takes files.
     *
     * @throws Complaint saying what is in the way; the file, or that there is none, stays as it was
     */
    public static void requireWritable(Path target) {
        Path folder = folder(target);
        if (Files.isRegularFile(folder))
            throw cannotWrite(target, folder + " is a file, a folder is wanted");
        if (!Files.isDirectory(folder)) throw cannotWrite(target, "no folder " + folder);
        if (Files.isDirectory(target)) throw cannotWrite(target, "it is a folder");
        if (Files.exists(target) && !Files.isRegularFile(target))
            throw cannotWrite(target, "it is a device, not a file");
        tryBeside(target, target);
    }

    /**
     * Passes if the folder takes files, or can be made and then will: tried before long work is
     * begun.
     *
     * @throws Complaint saying what is in the way; nothing is made
     */
    public static void requireFolderWritable(Path folder) {
        Path standing = folder;
        while (standing != null && !Files.exists(standing, LinkOption.NOFOLLOW_LINKS))
            standing = standing.getParent();
        if (standing == null) standing = Path.of("").toAbsolutePath();
        if (Files.isRegularFile(standing))
            throw Complaint.badInput(standing + ": is a file, a folder is wanted");
        if (!Files.isDirectory(standing)) throw Complaint.badInput(standing + ": is not a folder");
        tryBeside(standing.resolve("trial"), folder);
    }

    /** Makes a file beside another and removes it again, before the target is to be written. */
    private static void tryBeside(Path file, Path target) {
        Path trial = unfinished(file);
        try {
            Files.write(trial, new byte[0], StandardOpenOption.CREATE_NEW);
            Files.delete(trial);
        } catch (IOException e) {
            throw cannotWrite(
                    target,
                    "a file cannot be made in " + trial.getParent() + " (" + reason(e) + ")");
        }
    }

    private static Complaint cannotWrite(Path target, String reason) {
        return Complaint.badInput(target + ": cannot be written: " + reason);
    }

    /**
     * Makes the folder where it is missing.
     *
     * @throws Complaint if it cannot be made or written to
     */
    public static void requireFolder(Path folder) {
        requireFolderWritable(folder);
        try {
            Files.createDirectories(folder);
        } catch (IOException e) {
            throw Complaint.badInput(folder + ": cannot be made a folder: " + reason(e));
        }
    }

    /** The meaning of a file error, without the path that the message already has. */
    public static String reason(IOException e) {
        return switch (e.getClass().getSimpleName()) {
            case "NoSuchFileException" -> "no such file";
            case "AccessDeniedException" -> "no right to";
            case "FileAlreadyExistsException" -> "a file of that name is in the way";
            default -> other(e);
        };
    }

    private static String other(IOException e) {
        if (e instanceof FileSystemException file && file.getReason() != null)
            return file.getReason();
        return String.valueOf(e.getMessage());
    }

    private static Path folder(Path target) {
        Path absolute = target.toAbsolutePath();
        return absolute.getParent() == null ? absolute : absolute.getParent();
    }

    /** A name of this process's own in the same folder. */
    private static Path unfinished(Path target) {
        long process = ProcessHandle.current().pid();
        return folder(target).resolve("." + target.getFileName() + "." + process + ".part");
    }
}
