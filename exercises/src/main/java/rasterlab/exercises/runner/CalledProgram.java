package rasterlab.exercises.runner;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.node.MissingNode;
import java.lang.reflect.InvocationTargetException;
import java.lang.reflect.Method;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.Set;
import rasterlab.engine.study.LimitReached;
import rasterlab.engine.study.NoAnswer;
import rasterlab.engine.study.Verdict;
import rasterlab.exercises.Exercise;
import rasterlab.exercises.TopicGrading;
import rasterlab.exercises.child.ContractCalls;
import rasterlab.exercises.marking.TriedCall;
import rasterlab.exercises.runner.process.ChildLost;
import rasterlab.exercises.runner.process.TimeLimit;
import rasterlab.exercises.runner.scan.AllowList;
import rasterlab.exercises.runner.scan.ByteCodeCheck;
import rasterlab.exercises.score.Answer;
import rasterlab.exercises.score.Diagnostic;
import rasterlab.exercises.score.Finding;
import rasterlab.exercises.score.GradingVerdict;
import rasterlab.exercises.score.Message;
import rasterlab.exercises.topic.TopicGradings;

/**
 * A student's compiled program that is called one input at a time, in a child that is kept. One
 * that hangs is stopped, and one that ended is missing: the next call starts another.
 *
 * <p>Several threads may call; they take turns.
 */
public final class CalledProgram implements AutoCloseable {
    private static final int TRIES = 2;

    private final JudgeSettings settings;
    private final TopicGrading topic;
    private final String source;
    private final Children children;
    private final Models models;
    private final Exercise exercise;
    private Student student;

    CalledProgram(
            JudgeSettings settings,
            Exercise exercise,
            String source,
            Children children,
            Models models) {
        this.settings = settings;
        this.exercise = exercise;
        this.models = models;
        this.topic = TopicGradings.of(exercise);
        this.source = source;
        this.children = children;
    }

    /**
     * @throws NoAnswer saying in which line it is wrong
     */
    void compile(Compiling compiling) throws InterruptedException {
        var fault = SourceText.faultOf(source);
        if (fault.isPresent()) throw unusable(List.of(fault.get().diagnostic()));
        try {
            compiled(compiling.compile(children, source, limit()));
        } catch (ChildLost lost) {
            throw crashed("your program could not be compiled: " + lost.message());
        }
    }

    private TimeLimit limit() {
        return settings.patience().limit(settings.compileLimit());
    }

    private void compiled(Compilation compiled) {
        if (compiled.verdict() != GradingVerdict.OK) throw unusable(compiled.errors());
        String contract = topic.contract().getName().replace('.', '/');
        ByteCodeCheck.Result checked =
                new ByteCodeCheck(AllowList.of(topic.contract()))
                        .check(compiled.classes(), contract, source);
        if (!checked.refusals().isEmpty()) throw unusable(checked.refusals());
        student = student(checked.entry(), compiled.classes());
    }

    private Student student(String entry, Map<String, byte[]> classes) {
        return new Student(
                children,
                settings,
                ContractCalls.of(topic.contract()),
                Exercise.StatedLimits.NONE,
                entry,
                classes,
                false);
    }

    /**
     * A right method of the contract in this process, the one that {@link #slowness} is held
     * against; empty where the exercise has none.
     */
    public Optional<Object> reference() throws InterruptedException {
        return model().map(one -> OwnLoader.instance(one.entry(), one.classes(), topic.contract()));
    }

    private Optional<Models.Model> model() throws InterruptedException {
        try {
            return models.of(exercise, topic, children, settings);
        } catch (ChildLost lost) {
            return Optional.empty();
        }
    }

    /**
     * How many times as long as the reference the program takes for an item of those inputs'
     * answers, each timed in a process of its own, in turns; empty where it does not answer them
     * all or makes no item, or the machine does not let it be measured.
     *
     * @param inputs of the topic
     */
    public synchronized OptionalDouble slowness(List<?> inputs) throws InterruptedException {
        Optional<Models.Model> model = model();
        if (model.isEmpty() || inputs.isEmpty()) return OptionalDouble.empty();
        try (Student reference = student(model.get().entry(), model.get().classes())) {
            return new Slowness(topic, student, reference).measure(inputs);
        } catch (ChildLost lost) {
            student.close();
            return OptionalDouble.empty();
        }
    }

    /** Why it cannot run; the exercise says it in the words of the user's language. */
    private static NoAnswer unusable(List<Diagnostic> why) {
        int line = why.get(0).line();
        return crashed(
                line > 0
                        ? "your program cannot run because of line "
                                + line
                                + "; 'Check' in its exercise says why"
                        : "your program cannot run; 'Check' in its exercise says why");
    }

    /**
     * Has the program answer: its items go to the sinks that are among the arguments.
     *
     * @param method of the contract
     * @return null where the method returns nothing
     * @throws NoAnswer when it was stopped, ended or threw
     * @throws IllegalArgumentException with the program's own words when it refuses
     * @throws LimitReached when a sink takes no more
     */
    public synchronized Object call(Method method, Object[] arguments) {
        var call = new OneCall(method, arguments);
        for (int left = TRIES; left > 0; left--) {
            try {
                TriedCall tried = student.call(call);
                if (call.reached != null) throw call.reached;
                if (tried.answer().isEmpty()) throw stopped(tried.finding());
                return returned(tried.answer().get());
            } catch (ChildLost lost) {
                student.close();
            } catch (InterruptedException givenUp) {
                student.close();
                Thread.currentThread().interrupt();
                break;
            }
        }
        throw crashed("your program was ended from outside");
    }

    private NoAnswer stopped(Finding finding) {
        return switch (finding.verdict()) {
            case TIME_LIMIT ->
                    new NoAnswer(
                            Verdict.Kind.ENDLESS,
                            "your program did not answer within "
                                    + settings.callLimit().toMillis() / 1000.0
                                    + " s and was stopped");
            case MEMORY_LIMIT -> crashed("your program ran out of memory and was stopped");
            case OUTPUT_LIMIT -> crashed("your program went on and on and was stopped");
            case RUNTIME_ERROR -> crashed("your program cannot be made: " + finding.message());
            default -> crashed("your program ended without an answer");
        };
    }

    private static Object returned(Answer answer) {
        return switch (answer.ending()) {
            case RETURNED -> ((Optional<?>) answer.output().orElseThrow()).orElse(null);
            case THREW -> throw thrown(answer);
            case CUT, TOO_LONG ->
                    throw new NoAnswer(
                            Verdict.Kind.REFUSED,
                            "your program sent more than "
                                    + Exercise.StatedLimits.MOST_ITEMS
                                    + " items and was stopped");
            case NULL -> throw wrong("your program returned null");
            case OVERWROTE -> throw wrong("your program wrote into what it was only given to read");
            case UNUSABLE ->
                    throw wrong(
                            "your program's answer cannot be used: "
                                    + (answer.explanation().isEmpty()
                                            ? answer.message()
                                            : answer.explanation()));
        };
    }

    private static IllegalArgumentException thrown(Answer answer) {
        boolean refuses = answer.exception().equals(IllegalArgumentException.class.getName());
        if (refuses && !answer.message().isEmpty())
            return new IllegalArgumentException(answer.message());
        Message place = answer.place();
        return crashed(
                "your program threw "
                        + answer.thrown()
                        + (place.isEmpty() ? "" : ", in line " + answer.line()));
    }

    private static NoAnswer wrong(String said) {
        return new NoAnswer(Verdict.Kind.WRONG, said);
    }

    private static NoAnswer crashed(String said) {
        return new NoAnswer(Verdict.Kind.CRASHED, said);
    }

    /** Ends the child. */
    @Override
    public synchronized void close() {
        if (student != null) student.close();
    }

    /** One call of one method, which nobody judges. */
    private static final class OneCall implements TopicGrading.GradedCall {
        private final Method method;
        private final Object[] arguments;
        private LimitReached reached;

        OneCall(Method method, Object[] arguments) {
            this.method = method;
            this.arguments = arguments;
        }

        @Override
        public TopicGrading.CallLimits caps() {
            return TopicGrading.CallLimits.ofItems(Exercise.StatedLimits.MOST_ITEMS);
        }

        @Override
        public long items() {
            return 0;
        }

        @Override
        public Object recorded(Object program, int most) {
            try {
                return Optional.ofNullable(method.invoke(program, arguments));
            } catch (InvocationTargetException e) {
                if (e.getCause() instanceof LimitReached full) reached = full;
                if (e.getCause() instanceof RuntimeException told) throw told;
                throw (Error) e.getCause();
            } catch (IllegalAccessException e) {
                throw new AssertionError("a contract's methods are public", e);
            }
        }

        @Override
        public Finding judge(Answer answer) {
            return Finding.OK;
        }

        @Override
        public Finding check(Answer answer) {
            return Finding.OK;
        }

        @Override
        public Set<String> traits() {
            return Set.of();
        }

        @Override
        public JsonNode input() {
            return MissingNode.getInstance();
        }

        @Override
        public JsonNode exact() {
            return MissingNode.getInstance();
        }

        @Override
        public Message example() {
            return Message.NONE;
        }

        @Override
        public String scene(Optional<Answer> wrong) {
            return "";
        }
    }
}
