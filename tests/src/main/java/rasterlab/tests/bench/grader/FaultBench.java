package rasterlab.tests.bench.grader;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.NoSuchFileException;
import java.nio.file.Path;
import java.sql.SQLException;
import rasterlab.tests.bench.language.BenchWords;

/** Brings faults of the machine to servers, each to one of its own. */
final class FaultBench {
    private final Path home;
    private final boolean quick;
    private final BenchWords words;
    private final MeasuredLines out;

    /**
     * @param home folder of the program
     */
    FaultBench(Path home, boolean quick, BenchWords words, MeasuredLines out) {
        this.home = home;
        this.quick = quick;
        this.words = words;
        this.out = out;
    }

    /** Prints what a fault did, or why it was not measured. */
    void run(GraderPart part) throws IOException, InterruptedException, SQLException {
        if (part == GraderPart.CLOCK) {
            run("ahead", (folder, belongings) -> clock(folder, 1, belongings));
            run("back", (folder, belongings) -> clock(folder, -1, belongings));
            return;
        }
        run(part.word(), (folder, belongings) -> fault(part, folder, belongings));
    }

    private static SetClock clock(Path folder, int hours, Belongings belongings)
            throws IOException, NotMeasured {
        SetClock clock = SetClock.in(folder, hours);
        return belongings.add(() -> clock);
    }

    private ServerFault fault(GraderPart part, Path folder, Belongings belongings)
            throws IOException, InterruptedException, SQLException, NotMeasured {
        return switch (part) {
            case DISK -> {
                Path mounted = Files.createDirectory(folder.resolve("disk"));
                yield new FullDisk(belongings.add(() -> new SmallDisk(mounted)).mount());
            }
            case READONLY -> belongings.add(() -> new ReadOnlyFiles(folder)).tried();
            case LOCKED -> belongings.add(() -> new LockedFile(folder));
            case DATABASE -> new LostPostgres(folder, OwnPostgres.start(belongings)).withDatabase();
            case FILES -> {
                int atRest = filesAtRest();
                yield belongings.add(() -> new NoFilesLeft(folder, atRest));
            }
            default -> throw new IllegalArgumentException("no single fault: " + part);
        };
    }

    /** Makes a fault. */
    private interface FaultMaker {
        /**
         * @param folder in which it may put what it needs
         * @param belongings that is ended after it
         */
        ServerFault make(Path folder, Belongings belongings)
                throws IOException, InterruptedException, SQLException, NotMeasured;
    }

    private void run(String name, FaultMaker maker)
            throws IOException, InterruptedException, SQLException {
        String said = words.text("grader.fault." + name);
        try (var belongings = new Belongings()) {
            BenchFolder folder = belongings.add(BenchFolder::make);
            folder.keepingLogs(
                    () -> {
                        ServerFault fault = maker.make(folder.path(), belongings);
                        LabCall call = fault.of(LabCall.serve(home, fault.data()));
                        BenchServer server = BenchServer.start(call, folder, belongings);
                        new FaultTrial(said, fault, server, words, out).run(quick);
                    });
        } catch (NotMeasured missing) {
            out.println(words.text("grader.unmeasured", said, missing.in(words)));
        }
    }

    /** How many files a server has open that has graded and waits. */
    private int filesAtRest() throws IOException, InterruptedException, NotMeasured {
        try (var belongings = new Belongings()) {
            BenchFolder folder = belongings.add(BenchFolder::make);
            LabCall call = LabCall.serve(home, folder.path().resolve("course"));
            BenchServer server = BenchServer.start(call, folder, belongings);
            String student = server.join("Student");
            String source = BenchSources.right();
            server.graded(
                    student, GraderHttp.id(server.submit(student, BenchSources.EXERCISE, source)));
            return server.openFiles();
        } catch (NoSuchFileException untold) {
            throw new NotMeasured("grader.missing.files", untold.getMessage());
        }
    }
}
