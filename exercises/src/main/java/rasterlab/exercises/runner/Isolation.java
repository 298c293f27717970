package rasterlab.exercises.runner;

import java.util.ArrayList;
import java.util.List;
import java.util.stream.Stream;
import rasterlab.exercises.runner.process.Programs;
import rasterlab.exercises.score.Message;
import rasterlab.exercises.score.Report;

/**
 * The isolation of the student's method on this machine.
 *
 * @param name "bubblewrap" or "process limits only", as stored with a report; {@link
 *     Report#isolationIn} has it in other languages
 * @param message what it holds and what it lacks, for start-up, log and result page
 * @param missing the layers that are not there, one by one, each by its name
 * @param exam whether it is meant to hold against a determined attacker, so that exams may be
 *     graded; then nothing is missing
 */
public record Isolation(String name, Message message, List<Message> missing, boolean exam) {
    private static final String PREFIX = "isolation.";

    public Isolation {
        missing = List.copyOf(missing);
    }

    /** The missing layers, all of which an exam is promised; none where exams may be graded. */
    public Message missingForExams() {
        return missingBut(List.of());
    }

    /** The missing layers before images of Java are asked for, which take a folder to make. */
    public Message missingBeforeImages() {
        return missingBut(List.of(Message.of("missing.image-off")));
    }

    private Message missingBut(List<Message> passedOver) {
        Message all = Message.NONE;
        for (Message one : missing) if (!passedOver.contains(one)) all = all.and(one);
        return all;
    }

    /** The limit on the number of processes that the method can start. */
    enum ProcessLimit {
        HOLDS,
        NO_PRLIMIT,
        /** The account runs too many already, so that no child could start under the limit. */
        TOO_LOW,
        /** The kernel limits nobody's processes who is root outside of the box. */
        ROOT
    }

    /**
     * Namespaces, a small read-only root, no network, no other processes.
     *
     * @param image whether children run on a Java of the needed modules only
     * @param faults what is not there or was found not to hold, each of which alone rules exams out
     */
    static Isolation bubblewrap(
            String version, ProcessLimit limit, boolean image, List<Message> faults) {
        Message unlimited =
                switch (limit) {
                    case HOLDS -> Message.NONE;
                    case NO_PRLIMIT -> Message.of("isolation.no-prlimit");
                    case TOO_LOW -> Message.of("isolation.too-low", Programs.MOST_PROCESSES);
                    case ROOT -> Message.of("isolation.root");
                };
        List<Message> failures = new ArrayList<>();
        if (!unlimited.isEmpty()) failures.add(unlimited);
        failures.addAll(faults);
        Message said = Message.of(image ? "isolation.box" : "isolation.box-jdk", version);
        for (Message one : failures) said = said.and(one);
        List<Message> missing = new ArrayList<>();
        for (Message one : failures) missing.addAll(layers(one));
        boolean exam = failures.isEmpty();
        return new Isolation(Report.BUBBLEWRAP, said, missing, exam);
    }

    /**
     * Separate processes and their limits, nothing of the operating system's.
     *
     * @param reason why bubblewrap is not used
     * @param image why there is no Java image of the needed modules; nothing where there is one
     */
    static Isolation processLimits(Message reason, Message image) {
        return new Isolation(
                Report.PROCESS_LIMITS,
                Message.of("isolation.plain").and(reason),
                Stream.of(Message.of("isolation.no-box"), reason, image)
                        .flatMap(one -> layers(one).stream())
                        .toList(),
                false);
    }

    /** The names of the layers that a sentence on what is missing is about. */
    private static List<Message> layers(Message failures) {
        return failures.sentences().stream()
                .map(
                        one ->
                                Message.of(
                                        "missing." + one.key().substring(PREFIX.length()),
                                        one.arguments().toArray()))
                .toList();
    }

    /** The protection in that language, without the layers that are missing. */
    public String holds(String language) {
        return new Message(message.sentences().subList(0, 1)).in(language);
    }

    /** One honest line in that language. */
    public String describe(String language) {
        return message.in(language);
    }
}
