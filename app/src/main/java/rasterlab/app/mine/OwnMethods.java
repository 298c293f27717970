package rasterlab.app.mine;

import java.lang.reflect.Proxy;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.function.Consumer;
import rasterlab.engine.study.Method;
import rasterlab.engine.study.NoAnswer;
import rasterlab.engine.study.Topic;
import rasterlab.engine.study.Verdict;
import rasterlab.engine.study.WrongLength;
import rasterlab.exercises.Exercise;
import rasterlab.exercises.runner.Judge;
import rasterlab.exercises.runner.JudgeSettings;

/**
 * The programs of the user's own in a window, one for each topic. Each is a method of its topic by
 * the name {@link #NAME}, which no list of methods shows by itself; without a program that method
 * refuses all inputs and says how to get one. On any thread.
 */
public final class OwnMethods implements AutoCloseable {
    public static final String NAME = "mine";

    private final Map<String, OwnProgram> programs = new ConcurrentHashMap<>();
    private final Map<String, OwnProgram> shown = new ConcurrentHashMap<>();
    private final List<Consumer<String>> listeners = new CopyOnWriteArrayList<>();
    private final JudgeSettings settings;
    private Judge judge;
    private boolean closed;

    public OwnMethods() {
        this(JudgeSettings.once());
    }

    OwnMethods(JudgeSettings settings) {
        this.settings = settings;
    }

    /** Puts a program in the place of the one that its topic had; nothing is compiled yet. */
    public void bring(Exercise exercise, String source) {
        OwnProgram before = programs.get(exercise.topic());
        if (before != null && before.isOf(exercise, source)) return;
        programs.put(exercise.topic(), new OwnProgram(exercise, source, this::judge));
        if (before != null) before.close();
        listeners.forEach(each -> each.accept(exercise.topic()));
    }

    /** The program of a topic; empty before there is one. */
    public Optional<OwnProgram> of(String topic) {
        return Optional.ofNullable(programs.get(topic));
    }

    /** The topics whose programs have been waited for that long. */
    public List<String> awaited(Duration least) {
        return programs.entrySet().stream()
                .filter(one -> one.getValue().isAwaited(least))
                .map(Map.Entry::getKey)
                .toList();
    }

    /** Notes that a tab shows a topic's program, which is returned; empty where there is none. */
    public Optional<OwnProgram> showIn(String tab, String topic) {
        Optional<OwnProgram> program = of(topic);
        program.ifPresent(one -> shown.put(tab, one));
        return program;
    }

    /** Notes that a tab tells nothing of a program any more. */
    public void hideIn(String tab) {
        shown.remove(tab);
    }

    /** The programs that tabs show, by the tabs' names. */
    public Map<String, OwnProgram> shown() {
        return Map.copyOf(shown);
    }

    /**
     * The topic's method of that name, which may be the user's own.
     *
     * @throws IllegalArgumentException if there is none; the message lists those there are
     */
    public <C> Method<C> method(Topic<C, ?, ?> topic, String name) {
        return name.equals(NAME) ? mine(topic) : topic.method(name);
    }

    /** The name of the method to hold a program against where nobody says which. */
    public static String right(Topic<?, ?, ?> topic) {
        return right(topic.methods());
    }

    private static String right(List<? extends Method<?>> methods) {
        List<? extends Method<?>> right = methods.stream().filter(one -> !one.faulty()).toList();
        return right.stream()
                .filter(Method::promisesToBeRight)
                .findFirst()
                .<Method<?>>map(one -> one)
                .orElseGet(() -> right.get(0))
                .name();
    }

    /** The topic with the user's own method beside those of its list. */
    public <C, I, O> Topic<C, I, O> in(Topic<C, I, O> topic) {
        return new OwnTopic<>(topic, this, topic.methods());
    }

    /** The topic with the user's own method last in its list, where there is one. */
    public <C, I, O> Topic<C, I, O> listing(Topic<C, I, O> topic) {
        if (of(topic.name()).isEmpty()) return topic;
        return with(topic, List.of(mine(topic)));
    }

    /** The topic with other methods behind those of its list. */
    public <C, I, O> Topic<C, I, O> with(Topic<C, I, O> topic, List<Method<C>> others) {
        var methods = new ArrayList<>(topic.methods());
        methods.addAll(others);
        return only(topic, methods);
    }

    /** The topic with these methods alone in its list. */
    public <C, I, O> Topic<C, I, O> only(Topic<C, I, O> topic, List<Method<C>> methods) {
        return new OwnTopic<>(topic, this, List.copyOf(methods));
    }

    /**
     * Tells the listener the topic of each program that is brought from now on, on the thread that
     * brings it; the answer ends that.
     */
    public Runnable whenBrought(Consumer<String> listener) {
        listeners.add(listener);
        return () -> listeners.remove(listener);
    }

    @SuppressWarnings("unchecked") // the topic's grading makes methods of the topic's contract
    private <C> Method<C> mine(Topic<C, ?, ?> topic) {
        Object method = of(topic.name()).map(OwnProgram::method).orElseGet(() -> none(topic));
        return Method.failing(NAME, (C) method);
    }

    /** The refusal of an answer that has another length than its topic asks for. */
    public static NoAnswer misshapen(WrongLength length) {
        return new NoAnswer(
                Verdict.Kind.WRONG,
                "your program's answer has %d %s where %d were asked for"
                        .formatted(
                                length.got(),
                                length.got() == 1 ? "value" : "values",
                                length.asked()));
    }

    private static Object none(Topic<?, ?, ?> topic) {
        Class<?> contract = topic.contract();
        return Proxy.newProxyInstance(
                contract.getClassLoader(),
                new Class<?>[] {contract},
                (proxy, method, arguments) -> {
                    throw new NoAnswer(
                            Verdict.Kind.REFUSED,
                            "there is no program of yours yet: press 'In the lab' in an exercise"
                                    + " on this topic");
                });
    }

    /** The one judge of all programs, which takes a second to start. */
    private synchronized Judge judge() {
        if (closed) throw new NoAnswer(Verdict.Kind.CRASHED, "your program was ended from outside");
        if (judge == null) judge = Judge.start(settings);
        return judge;
    }

    /** Ends all programs. */
    @Override
    public synchronized void close() {
        closed = true;
        programs.values().forEach(OwnProgram::close);
        if (judge != null) judge.close();
    }
}
