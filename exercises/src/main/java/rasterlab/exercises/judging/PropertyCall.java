package rasterlab.exercises.judging;

import com.fasterxml.jackson.databind.JsonNode;
import java.util.ArrayList;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.stream.Stream;
import rasterlab.engine.study.Topic;
import rasterlab.exercises.Exercise.ExerciseTolerance;
import rasterlab.exercises.TopicGrading;
import rasterlab.exercises.TopicGrading.CallLimits;
import rasterlab.exercises.TopicGrading.GradedCall;
import rasterlab.exercises.property.Property;
import rasterlab.exercises.property.Relation.AnsweredInput;
import rasterlab.exercises.property.Relation.Broken;
import rasterlab.exercises.property.SmallerInputs;
import rasterlab.exercises.property.SmallerInputs.SmallerInput;
import rasterlab.exercises.score.Answer;
import rasterlab.exercises.score.Cause;
import rasterlab.exercises.score.Finding;
import rasterlab.exercises.score.GradingVerdict;
import rasterlab.exercises.score.Message;

/**
 * An input, those that a property makes of it, and how a method's answers to them are judged.
 *
 * <p>A method that keeps a property by wrong answers, such as by drawing nothing, earns nothing for
 * it; and where all answers are right to the tolerance, what they differ by is no fault.
 */
final class PropertyCall<C, I, O> implements GradedCall {
    private final ByTopic<C, I, O> grading;
    private final Property<I, O> property;
    private final I input;
    private final ExerciseTolerance tolerance;
    private final int tries;
    private final Optional<SmallerInput> from;
    private final InputCall<C, I, O> own;

    /**
     * @param tries number of inputs that the case asks for
     * @param from what it was made of one of them as; empty for one of them
     */
    PropertyCall(
            ByTopic<C, I, O> grading,
            Property<I, O> property,
            I input,
            ExerciseTolerance tolerance,
            int tries,
            Optional<SmallerInput> from) {
        this.grading = grading;
        this.property = property;
        this.input = input;
        this.tolerance = tolerance;
        this.tries = tries;
        this.from = from;
        this.own = new InputCall<>(grading, input, grading.demand(input, tolerance));
    }

    /**
     * All answers that the property is about.
     *
     * @param complete whether the further inputs could be made of the first answer
     */
    private record Answers<I, O>(
            AnsweredInput<I, O> first, List<AnsweredInput<I, O>> further, boolean complete) {
        Stream<AnsweredInput<I, O>> all() {
            return Stream.concat(Stream.of(first), further.stream());
        }
    }

    private Topic<C, I, O> topic() {
        return grading.topic();
    }

    private InputCall<C, I, O> alone(I one) {
        if (one == input) return own;
        return new InputCall<>(grading, one, grading.demand(one, tolerance));
    }

    /** {@inheritDoc} Of an input that is made of this one, at most twice as many. */
    @Override
    public CallLimits caps() {
        return CallLimits.ofItems(topic().mostBeforeEndless(2 * items()));
    }

    @Override
    public long items() {
        return own.items();
    }

    @Override
    public Object recorded(Object method, int most) {
        C whole = grading.whole(method);
        var first = new AnsweredInput<>(input, topic().record(whole, input, most));
        List<I> further;
        try {
            further = property.relation().furtherInputs(input, first.output());
        } catch (IllegalArgumentException noInput) {
            return new Answers<>(first, List.of(), false);
        }
        List<AnsweredInput<I, O>> beside = new ArrayList<>();
        for (I one : further)
            beside.add(new AnsweredInput<>(one, topic().record(whole, one, most)));
        return new Answers<>(first, beside, true);
    }

    @Override
    public Finding judge(Answer answer) {
        return judged(answer, Optional.of(InputCall::judge));
    }

    @Override
    public Finding check(Answer answer) {
        return judged(answer, Optional.empty());
    }

    @Override
    public Finding judgeIdle(Answer answer, Cause idle) {
        return judged(answer, Optional.of((alone, its) -> alone.judgeIdle(its, idle)));
    }

    /** {@inheritDoc} Each of its answers is one of such. */
    @Override
    public Optional<Cause> idle(Answer answer) {
        Optional<Answers<I, O>> got = answers(answer);
        if (got.isEmpty()) return Optional.empty();
        List<Optional<Cause>> causes =
                got.get().all().map(one -> alone(one.input()).idle(answer(one))).toList();
        return causes.stream().allMatch(Optional::isPresent) ? causes.get(0) : Optional.empty();
    }

    /** Judges the one answer that is wrong. */
    private interface Alone<C, I, O> {
        Finding of(InputCall<C, I, O> alone, Answer its);
    }

    /**
     * @param whole tells all of the answer that is wrong; empty where its causes are enough
     */
    private Finding judged(Answer answer, Optional<Alone<C, I, O>> whole) {
        Optional<Answers<I, O>> got = answers(answer);
        if (got.isEmpty()) return Failure.of(answer, false);
        Optional<Broken<I, O>> broken = broken(got.get());
        Optional<AnsweredInput<I, O>> wrong = wrong(got.get(), broken.isPresent());
        if (wrong.isEmpty()) return Finding.OK;
        InputCall<C, I, O> alone = alone(wrong.get().input());
        Answer its = answer(wrong.get());
        return whole.map(
                        judge ->
                                finding(
                                        got.get(),
                                        broken,
                                        wrong.get().input(),
                                        judge.of(alone, its)))
                .orElseGet(() -> alone.check(its));
    }

    /** The recorded answer; empty where the method did not get so far. */
    @SuppressWarnings("unchecked") // recorded by this class
    private Optional<Answers<I, O>> answers(Answer answer) {
        return answer.ending() == Answer.CallEnding.RETURNED
                ? answer.output().map(output -> (Answers<I, O>) output)
                : Optional.empty();
    }

    private Optional<Broken<I, O>> broken(Answers<I, O> got) {
        return got.complete()
                ? property.relation().broken(got.first(), got.further(), this::isAlike)
                : Optional.empty();
    }

    private boolean isAlike(I one, O wanted, O output) {
        return grading.isRight(one, wanted, output, tolerance);
    }

    /**
     * The first answer that is wrong; where the property holds, only that to its own input. What
     * was made of a wrong answer may be no input that has a right one.
     */
    private Optional<AnsweredInput<I, O>> wrong(Answers<I, O> got, boolean broken) {
        return got.all()
                .limit(broken ? Long.MAX_VALUE : 1)
                .filter(one -> alone(one.input()).isAnswered())
                .filter(one -> !alone(one.input()).check(answer(one)).right())
                .findFirst();
    }

    private static Answer answer(AnsweredInput<?, ?> one) {
        return Answer.with(Answer.CallEnding.RETURNED, one.output(), 1, "", "");
    }

    /**
     * Tells a broken property in words only: the answer that the property expects comes from
     * another answer of the method and may be as wrong, so the pictures are those of the input
     * whose answer is wrong.
     *
     * @param mine the input whose answer is wrong
     * @param wrong what is told of it alone
     */
    private Finding finding(
            Answers<I, O> got, Optional<Broken<I, O>> broken, I mine, Finding wrong) {
        if (broken.isEmpty())
            return new Finding(
                    GradingVerdict.WRONG,
                    Message.of("property.by-wrong").and(wrong.message()),
                    wrong.pictures(),
                    wrong.explanations());
        I other = broken.get().answered().input();
        Optional<O> wanted = broken.get().wanted();
        O output = broken.get().answered().output();
        Message broke = property.broken().and(counterexample(other));
        Message unfit = wanted.map(one -> unfit(other, one, output)).orElse(broken.get().message());
        Message which = whichIsWrong(mine, other);
        Message itself = which.isEmpty() ? without(unfit, wrong.message()) : wrong.message();
        Message said = BriefMessage.of(broke, unfit, property.rule(), which, itself);
        return new Finding(GradingVerdict.WRONG, said, wrong.pictures(), wrong.explanations());
    }

    /** The sentences that have not been told of the same answer. */
    private static Message without(Message told, Message said) {
        return new Message(
                said.sentences().stream().filter(one -> !told.sentences().contains(one)).toList());
    }

    private Message unfit(I other, O wanted, O output) {
        return AnswerDifference.unfit(topic(), other, wanted, output, grading.isInOrder());
    }

    /** The input whose answer is wrong, without its text where that has been told. */
    private Message whichIsWrong(I mine, I other) {
        if (mine.equals(input))
            return other.equals(input) ? Message.NONE : Message.of("property.wrong-itself");
        return mine.equals(other) && !isLong(input) && !isLong(other)
                ? Message.of("property.wrong-beside")
                : shown("property.wrong", mine);
    }

    /** The input, and the one that breaks the property where that is another. */
    private Message counterexample(I other) {
        if (isLong(input)) return Message.of("property.long", tries);
        String key = from.isPresent() ? "property.smallest" : "property.found";
        Message found = Message.of(key, tries, json(input));
        return other.equals(input) ? found : found.and(shown("property.beside", other));
    }

    /** The value in words, or nothing where it is long. */
    private Message shown(String key, I one) {
        return isLong(one) ? Message.NONE : Message.of(key, json(one));
    }

    private boolean isLong(I one) {
        return json(one).length() > ByTopic.LONGEST_EXAMPLE;
    }

    private String json(I one) {
        return Leaves.json(topic().format(), one);
    }

    @Override
    public boolean breaksProperty(Answer answer) {
        return answers(answer).flatMap(this::broken).isPresent();
    }

    /** {@inheritDoc} Where no answer came, it cannot be told to which. */
    @Override
    public GradedCall inQuestion(Answer answer) {
        Optional<Answers<I, O>> got = answers(answer);
        if (got.isEmpty()) return this;
        return wrong(got.get(), true).map(one -> alone(one.input())).orElse(own);
    }

    @Override
    public Message held() {
        return property.held(tries).and(property.rule());
    }

    @Override
    public Stream<GradedCall> smaller() {
        SmallerInput start = from.orElseGet(() -> SmallerInput.first(input()));
        return SmallerInputs.of(start).flatMap(one -> shrunkTo(one).stream());
    }

    /**
     * The call on a smaller input; empty where that is no input with a right answer, or none that
     * the property speaks of.
     */
    private Optional<GradedCall> shrunkTo(SmallerInput smaller) {
        return TopicInputs.read(topic().format(), smaller.json())
                .filter(property.assumed())
                .map(
                        one ->
                                new PropertyCall<>(
                                        grading,
                                        property,
                                        one,
                                        tolerance,
                                        tries,
                                        Optional.of(smaller)))
                .filter(one -> one.own.isAnswered())
                .map(GradedCall.class::cast);
    }

    @Override
    public boolean isRightWith(String mistake) {
        return own.isRightWith(mistake);
    }

    @Override
    public Set<String> traits() {
        Set<String> traits = new LinkedHashSet<>(own.traits());
        traits.add(TopicGrading.SEVERAL);
        return traits;
    }

    @Override
    public JsonNode input() {
        return own.input();
    }

    @Override
    public JsonNode exact() {
        return own.exact();
    }

    @Override
    public Message example() {
        return grading.example(input);
    }

    /** {@inheritDoc} Of the answers, the first that is wrong. */
    @Override
    public String scene(Optional<Answer> wrong) {
        return wrong.flatMap(this::answers)
                .flatMap(got -> wrong(got, true))
                .map(one -> alone(one.input()).scene(Optional.of(answer(one))))
                .orElseGet(() -> own.scene(Optional.empty()));
    }
}
