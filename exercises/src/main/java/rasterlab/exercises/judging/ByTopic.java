package rasterlab.exercises.judging;

import com.fasterxml.jackson.databind.JsonNode;
import java.util.Collection;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Random;
import java.util.Set;
import java.util.TreeSet;
import java.util.function.Predicate;
import java.util.function.Supplier;
import rasterlab.engine.polygon.triangulation.Triangles;
import rasterlab.engine.raster.PixelRecording;
import rasterlab.engine.study.Method;
import rasterlab.engine.study.Topic;
import rasterlab.exercises.CatalogueException;
import rasterlab.exercises.Exercise;
import rasterlab.exercises.Exercise.Case;
import rasterlab.exercises.Exercise.ExerciseTolerance;
import rasterlab.exercises.TopicGrading;
import rasterlab.exercises.property.Properties;
import rasterlab.exercises.property.Property;
import rasterlab.exercises.scene.MethodCase;
import rasterlab.exercises.score.Answer;
import rasterlab.exercises.score.CasePicture;
import rasterlab.exercises.score.Cause;
import rasterlab.exercises.score.Finding;
import rasterlab.exercises.score.Message;
import rasterlab.exercises.score.Phrase;

/**
 * Grades any topic by its own exact answer, its own comparison, and its own faulty methods and
 * mutants. A topic adds what a student's speed is held against and how its answers are drawn; a
 * kind of output, what it tells of a wrong answer by itself.
 *
 * @param <C> the contract
 * @param <I> one input
 * @param <O> one output
 */
public abstract class ByTopic<C, I, O> implements TopicGrading {
    /** Characters of an input that is told as an example. */
    static final int LONGEST_EXAMPLE = 160;

    private final Topic<C, I, O> topic;
    private final Class<?> contract;
    private final Optional<C> reference;

    /** Each exercise brings its own right method to hold a student's speed against. */
    protected ByTopic(Topic<C, I, O> topic) {
        this(topic, topic.contract());
    }

    /**
     * @param contract what a student implements in place of the topic's own
     */
    protected ByTopic(Topic<C, I, O> topic, Class<?> contract) {
        this.topic = topic;
        this.contract = contract;
        this.reference = Optional.empty();
    }

    /**
     * @param reference a right method, as plain as a student writes it; its class has a constructor
     *     without parameters and needs no other class but those of its package
     */
    protected ByTopic(Topic<C, I, O> topic, C reference) {
        this.topic = topic;
        this.contract = topic.contract();
        this.reference = Optional.of(reference);
    }

    /**
     * Draws what is expected and what came.
     *
     * @param exact the right answer
     * @param actual an answer that is not right
     */
    protected abstract List<CasePicture> pictures(I input, O exact, O actual);

    /**
     * A method as the topic calls it.
     *
     * @param method of the topic's contract, or of what an exercise asks for in its place
     */
    @SuppressWarnings("unchecked") // the caller has it from this grading's contract
    protected C whole(Object method) {
        return (C) method;
    }

    /** The number of items of the right answer. */
    protected long items(I input) {
        return topic.spend(plain(), input);
    }

    /** Whether all right answers have their items in one order, so that a case may cut them. */
    protected boolean isInOrder() {
        return false;
    }

    /**
     * The right answer that is nearest to that one, as far as it is looked at.
     *
     * @param truth gives the right answer of the exercise
     */
    protected O right(I input, Supplier<O> truth, O actual, Demand demand) {
        return truth.get();
    }

    /** The right answer of the exercise: the topic's, or that of the method that it names. */
    final O truth(I input, ExerciseTolerance tolerance, int items) {
        return tolerance
                .truth()
                .map(name -> topic.record(topic.method(name).implementation(), input, items))
                .orElseGet(() -> topic.exact(input, items));
    }

    /** Whether an output is right for that input. */
    protected boolean isRight(I input, O exact, O actual, ExerciseTolerance tolerance) {
        var deviation = topic.compare(input, exact, actual);
        boolean within =
                tolerance.worst().isPresent()
                        && deviation.missing() == 0
                        && deviation.extra() == 0
                        && deviation.worst() <= tolerance.worst().getAsDouble();
        return within || topic.correct(deviation);
    }

    /** Which outputs tell of the same mistake as that one, where they are not alike in worth. */
    protected Predicate<O> sameAs(I input, O actual) {
        Leaves[] asked = new Leaves[1];
        return known -> {
            if (known instanceof PixelRecording one && actual instanceof PixelRecording other)
                return SamePixels.are(topic, input, one, other);
            if (known instanceof Triangles one
                    && actual instanceof Triangles other
                    && SameTriangles.areTurnedOver(topic, input, one, other)) return true;
            if (asked[0] == null) asked[0] = Leaves.of(topic.format(), input, actual);
            return Leaves.of(topic.format(), input, known).equals(asked[0]);
        };
    }

    /** Codes of the mistakes that the kind of output tells by itself. */
    protected Set<String> ownMistakes() {
        return Set.of();
    }

    /**
     * The explanations that the kind of output has for a wrong answer, the likeliest first; none
     * where it has none.
     */
    protected List<List<Cause>> explanations(I input, O actual, Demand demand) {
        return List.of();
    }

    /** The key of the text on a faulty method of the topic that gives the same answer. */
    protected String knownMethod() {
        return "known-answer.told";
    }

    /** Tells what such a method is known to do wrong, and its name. */
    final Message knownFault(String method) {
        return Message.of(knownMethod(), method, "faults." + topic.name() + "." + method);
    }

    /** The first part of a wrong answer that differs, and how far all of it is from right. */
    protected Message difference(I input, O right, O actual) {
        return AnswerDifference.of(topic, input, right, actual);
    }

    /** The item that is told to differ; empty where none is that a method decides on. */
    protected Optional<DifferingItem> differing(I input, O right, O actual, Message said) {
        if (right instanceof PixelRecording wanted && actual instanceof PixelRecording drawn)
            return new PixelErrors(wanted, drawn).first().map(DifferingItem::at);
        return said.place()
                .flatMap(at -> DifferingItem.at(at, json(input, right), json(input, actual)));
    }

    /**
     * The right answer that a wrong one is shown beside.
     *
     * @param right the right one that is nearest to it
     */
    protected O shownRight(I input, O right, O actual, Demand demand, List<List<Cause>> causes) {
        return right;
    }

    /** The name of a faulty method that is to be told beside what explains a wrong answer. */
    protected Optional<String> further(I input, O actual, Demand demand) {
        return Optional.empty();
    }

    /** The finding on an answer that goes on beyond the most items, which it has. */
    protected Finding endless(I input, Answer answer, Demand demand, boolean whole) {
        return Failure.of(answer, demand.mayRefuse());
    }

    /** The traits of that input, as codes of texts {@code where.CODE}. */
    protected Set<String> traits(I input) {
        return Set.of();
    }

    /** The input in words, as an example of where a mistake is seen; nothing where it is long. */
    protected Message example(I input) {
        String json = Leaves.json(topic.format(), input);
        return json.length() > LONGEST_EXAMPLE ? Message.NONE : Message.of("answer.example", json);
    }

    /** The topic's method that exercises ask for; empty where any right one will do. */
    protected Optional<String> method() {
        return Optional.empty();
    }

    /** The view in the lab of a student's answer beside the right one. */
    protected Optional<MethodCase.DrawnPixels> drawn(Answer answer) {
        return Optional.empty();
    }

    /**
     * Makes batches of inputs to time a method on; the answer to one of them is judged.
     *
     * @param inputs draws new ones each time
     */
    protected Timings timings(
            Supplier<List<TimedInput<I>>> inputs, ExerciseTolerance tolerance, Random random) {
        return () ->
                new InputBatch<>(
                        this,
                        inputs.get().stream().map(TimedInput::input).toList(),
                        tolerance,
                        random);
    }

    @Override
    public final Map<String, Object> classics() {
        Map<String, Object> classics = new LinkedHashMap<>();
        for (Method<C> one : topic.methods())
            if (!one.faulty()) classics.put(one.name(), one.implementation());
        return classics;
    }

    @Override
    public final String name() {
        return topic.name();
    }

    @Override
    public final Class<?> contract() {
        return contract;
    }

    @Override
    public final Optional<Class<?>> reference() {
        return reference.map(Object::getClass);
    }

    @Override
    public Optional<String> unit() {
        return Optional.of(topic.errorUnit());
    }

    @Override
    public List<String> truths() {
        return topic.methods().stream().filter(one -> !one.faulty()).map(Method::name).toList();
    }

    @Override
    public final List<GradedCall> calls(Case one, ExerciseTolerance tolerance, long seed) {
        TopicInputs.Read<I> read = new TopicInputs<>(topic, isInOrder()).of(one, seed);
        if (one.property().isPresent())
            return propertyCalls(one, one.property().get(), tolerance, read.inputs());
        return read.inputs().stream()
                .<GradedCall>map(
                        input -> new InputCall<>(this, input, demand(one, input, tolerance, read)))
                .toList();
    }

    /** Where the rule that the property assumes does not decide an input, it is not asked. */
    private List<GradedCall> propertyCalls(
            Case one, String name, ExerciseTolerance tolerance, List<I> drawn) {
        Property<I, O> property = property(name);
        List<I> inputs = drawn.stream().filter(property.assumed()).toList();
        if (inputs.isEmpty())
            throw new CatalogueException(
                    Phrase.of(
                            "field.wrong",
                            TopicInputs.place(one),
                            Phrase.of("property.none-assumed", name, drawn.size())));
        return inputs.stream()
                .<GradedCall>map(
                        input ->
                                new PropertyCall<>(
                                        this,
                                        property,
                                        input,
                                        tolerance,
                                        inputs.size(),
                                        Optional.empty()))
                .toList();
    }

    @SuppressWarnings("unchecked") // a property of this topic
    private Property<I, O> property(String name) {
        return (Property<I, O>)
                Properties.of(topic.name()).stream()
                        .filter(one -> one.name().equals(name))
                        .findFirst()
                        .orElseThrow();
    }

    /** The demand on an answer of which all is looked at. */
    final Demand demand(I input, ExerciseTolerance tolerance) {
        int most = topic.mostItems();
        return new Demand(
                tolerance, false, false, isInOrder() ? (int) Math.min(most, items(input)) : most);
    }

    private Demand demand(
            Case one, I input, ExerciseTolerance tolerance, TopicInputs.Read<I> read) {
        ExerciseTolerance held = read.strict() ? tolerance.strict() : tolerance;
        if (!isInOrder()) return new Demand(held, read.mayRefuse(), false, topic.mostItems());
        int most = read.first().orElse(topic.mostItems());
        long items = items(input);
        if (items > most && read.first().isEmpty())
            throw new CatalogueException(
                    Phrase.of(
                            "field.wrong",
                            Phrase.of("field", TopicInputs.place(one), "first"),
                            Phrase.of("field.cut", most)));
        return new Demand(held, read.mayRefuse(), items > most, (int) Math.min(most, items));
    }

    @Override
    public final Set<String> mistakes() {
        Set<String> codes = new TreeSet<>(ownMistakes());
        topic.methods().stream().filter(Method::faulty).forEach(one -> codes.add(one.name()));
        topic.allMutants().forEach(one -> codes.add(one.name()));
        return codes;
    }

    @Override
    public final Timings timings(
            Exercise exercise, Random random, Collection<Set<String>> wrongOn) {
        return timings(
                new TimedInputs<>(topic, exercise, random, wrongOn), exercise.tolerance(), random);
    }

    @Override
    @SuppressWarnings("unchecked") // the caller has them from this topic
    public final TimingInputs timing(List<?> inputs) {
        return new InputBatch<>(
                this, (List<I>) inputs, new ExerciseTolerance(false), new Random(1));
    }

    @Override
    public final Object asMethod(Object method) {
        return whole(method);
    }

    @Override
    public final Object right() {
        return plain();
    }

    protected final Topic<C, I, O> topic() {
        return topic;
    }

    /** A method that is right, or refuses. */
    protected final C plain() {
        return reference.orElseGet(() -> promising().implementation());
    }

    /** The first of the topic's methods that no failure is known of and an exercise may ask for. */
    private Method<C> promising() {
        List<Method<C>> right =
                topic.methods().stream()
                        .filter(one -> !one.faulty() && contract.isInstance(one.implementation()))
                        .toList();
        return right.stream()
                .filter(Method::promisesToBeRight)
                .findFirst()
                .or(() -> right.stream().findFirst())
                .orElseThrow();
    }

    /** An input as {@code ./lab run} takes it. */
    protected final JsonNode json(I input) {
        return Leaves.tree(topic.format(), input);
    }

    /** An output as {@code ./lab run} answers it; what is no number stands by its name. */
    protected final JsonNode json(I input, O output) {
        return Leaves.tree(topic.format(), input, output);
    }
}
