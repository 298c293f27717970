package rasterlab.exercises.runner.process;

import java.io.IOException;
import java.nio.file.DirectoryNotEmptyException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.locks.LockSupport;

/** A control group that one child has to itself. */
public final class ControlGroup {
    /** A time longer than the kernel needs to end killed processes, in looks of a millisecond. */
    private static final int MOST_LOOKS = 2000;

    private static final long LOOK_NANOS = 1_000_000;
    private static final String PROCESSES = "cgroup.procs";
    private static final String JOIN_AND_RUN = "echo $$ >\"$0\" && exec \"$@\"";

    private final Path folder;

    ControlGroup(Path folder) {
        this.folder = folder;
    }

    void limit(String name, String value) throws IOException {
        Path file = folder.resolve(name);
        Files.writeString(file, value);
        String found = Files.readString(file).strip();
        if (!found.equals(value))
            throw new IOException(name + " is " + found + " after " + value + " was set");
    }

    /** Sets what some kernels do not have. */
    void limitWhereThere(String name, String value) throws IOException {
        if (Files.exists(folder.resolve(name))) Files.writeString(folder.resolve(name), value);
    }

    /** That command, by a process that is in this group before it begins. */
    public List<String> joined(List<String> command) {
        List<String> joined = new ArrayList<>();
        // the shell only writes its own number: nothing of a submission is in its words
        joined.addAll(List.of("/bin/sh", "-c", JOIN_AND_RUN));
        joined.add(folder.resolve(PROCESSES).toString());
        joined.addAll(command);
        return joined;
    }

    /** Whether that process is in it. */
    public boolean has(long process) throws IOException {
        return ControlGroups.words(folder.resolve(PROCESSES)).contains(Long.toString(process));
    }

    /** Whether the kernel ended a process of it because its memory was used up. */
    public boolean isOutOfMemory() {
        try {
            return Files.readAllLines(folder.resolve("memory.events")).stream()
                    .map(line -> line.split(" "))
                    .anyMatch(words -> words[0].equals("oom_kill") && !words[1].equals("0"));
        } catch (IOException gone) {
            return false;
        }
    }

    /** Kills what is in it and removes it. */
    public void end() {
        try {
            Path kill = folder.resolve("cgroup.kill");
            if (Files.exists(kill)) Files.writeString(kill, "1");
        } catch (IOException noOneLeft) {
            // then it can be removed
        }
        IOException failed = null;
        for (int look = 0; look < MOST_LOOKS && Files.isDirectory(folder); look++)
            try {
                Files.delete(folder);
                return;
            } catch (DirectoryNotEmptyException noGroup) {
                failed = noGroup;
                break;
            } catch (IOException busy) {
                failed = busy;
                LockSupport.parkNanos(LOOK_NANOS);
            }
        if (failed != null)
            System.getLogger(ControlGroup.class.getName())
                    .log(System.Logger.Level.WARNING, "cannot remove {0}: {1}", folder, failed);
    }
}
