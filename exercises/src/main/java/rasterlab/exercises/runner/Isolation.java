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
 *     graded; then nothing is missing but {@link #UNPROMISED}
 */
public record Isolation(String name, Message message, List<Message> missing, boolean exam) {
    private static final String PREFIX = "isolation.";

    /** The layers that are nowhere there yet, and that exams are not promised. */
    private static final List<Message> UNPROMISED =
            List.of(Message.of("missing.groups"), Message.of("missing.image"));

    public Isolation {
        missing = List.copyOf(missing);
    }

    /** The missing layers that an exam is promised; none where exams may be graded. */
    public Message missingForExams() {
        Message all = Message.NONE;
        for (Message one : missing) if (!UNPROMISED.contains(one)) all = all.and(one);
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
     * @param faults what was found not to hold, each of which alone rules exams out
     */
    static Isolation bubblewrap(String version, ProcessLimit limit, List<Message> faults) {
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
        Message said = Message.of("isolation.box", version).and(Message.of("isolation.without"));
        for (Message one : failures) said = said.and(one);
        List<Message> missing = new ArrayList<>(UNPROMISED);
        for (Message one : failures) missing.addAll(layers(one));
        boolean exam = limit == ProcessLimit.HOLDS && faults.isEmpty();
        return new Isolation(Report.BUBBLEWRAP, said, missing, exam);
    }

    /**
     * Separate processes and their limits, nothing of the operating system's.
     *
     * @param reason why bubblewrap is not used
     */
    static Isolation processLimits(Message reason) {
        return new Isolation(
                Report.PROCESS_LIMITS,
                Message.of("isolation.plain").and(reason),
                Stream.of(Message.of("isolation.no-box"), reason)
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
