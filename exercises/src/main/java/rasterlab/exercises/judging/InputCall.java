package rasterlab.exercises.judging;

import com.fasterxml.jackson.databind.JsonNode;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.Set;
import rasterlab.engine.study.Deviation;
import rasterlab.engine.study.LimitReached;
import rasterlab.engine.study.Method;
import rasterlab.engine.study.Topic;
import rasterlab.exercises.TopicGrading.CallLimits;
import rasterlab.exercises.TopicGrading.GradedCall;
import rasterlab.exercises.scene.MethodCase;
import rasterlab.exercises.score.Answer;
import rasterlab.exercises.score.Cause;
import rasterlab.exercises.score.Finding;
import rasterlab.exercises.score.GradingVerdict;
import rasterlab.exercises.score.KnownChanges;
import rasterlab.exercises.score.Message;

/** One input of a topic and how an answer to it is judged. */
final class InputCall<C, I, O> implements GradedCall {
    private final ByTopic<C, I, O> grading;
    private final I input;
    private final Demand demand;

    /**
     * The right answer, worked out when it is first asked for, which may take long, and kept for
     * further answers.
     */
    private O truth;

    /** The known mistakes, whose answers to this input are worked out once. */
    private final KnownMistakes<C, I, O> known;

    InputCall(ByTopic<C, I, O> grading, I input, Demand demand) {
        this.grading = grading;
        this.input = input;
        this.demand = demand;
        this.known =
                new KnownMistakes<>(
                        grading, input, demand, this::right, () -> truth(demand.items()));
    }

    private Topic<C, I, O> topic() {
        return grading.topic();
    }

    @Override
    public CallLimits caps() {
        return CallLimits.ofItems(
                demand.cut() ? demand.items() : topic().mostBeforeEndless(items()));
    }

    /** The number of items; none where the right method refuses the input. */
    @Override
    public long items() {
        if (demand.cut()) return demand.items();
        try {
            return grading.items(input);
        } catch (IllegalArgumentException refused) {
            return 0;
        }
    }

    @Override
    public Object recorded(Object method, int most) {
        return topic().record(grading.whole(method), input, most);
    }

    @Override
    public Finding judge(Answer answer) {
        return judged(answer, true, Optional.empty());
    }

    @Override
    public Finding check(Answer answer) {
        return judged(answer, false, Optional.empty());
    }

    @Override
    public Finding judgeIdle(Answer answer, Cause idle) {
        return judged(answer, true, Optional.of(idle));
    }

    @Override
    @SuppressWarnings("unchecked") // recorded by this class
    public Optional<Cause> idle(Answer answer) {
        if (answer.ending() != Answer.CallEnding.RETURNED) return Optional.empty();
        return answer.output().flatMap(output -> Idle.cause(grading, input, (O) output));
    }

    @SuppressWarnings("unchecked") // recorded by this class
    private Finding judged(Answer answer, boolean whole, Optional<Cause> idle) {
        if (answer.output().isEmpty()) return Failure.of(answer, demand.mayRefuse());
        if (answer.ending() == Answer.CallEnding.CUT && !demand.cut())
            return grading.endless(input, answer, demand, whole);
        O actual = (O) answer.output().get();
        O right = right(actual);
        if (grading.isRight(input, right, actual, demand.tolerance())) return Finding.OK;
        List<List<Cause>> own = grading.explanations(input, actual, demand);
        List<List<Cause>> causes =
                idle.map(one -> List.of(List.of(one)))
                        .orElseGet(() -> own.isEmpty() ? known.of(actual) : own);
        if (!whole) return Finding.of(GradingVerdict.WRONG, Message.NONE, causes);
        O beside = grading.shownRight(input, right, actual, demand, causes);
        Message differs =
                refusal()
                        .map(why -> Message.of("refusal.wanted", why))
                        .orElseGet(() -> grading.difference(input, beside, actual));
        Message said = differs.and(decided(beside, actual, differs));
        // where several mistakes that are known give this answer, none of them is told
        boolean sure =
                idle.isPresent() || !own.isEmpty() || known.areOne(causes) && !areChanges(causes);
        List<Cause> told = sure ? causes.get(0) : List.of();
        for (Cause one : told) said = said.and(one.message());
        if (told.isEmpty()) said = said.and(AnswerDifference.kind(beside, actual));
        if (idle.isPresent())
            return new Finding(
                    GradingVerdict.WRONG, said, grading.pictures(input, beside, actual), causes);
        Optional<String> further = grading.further(input, actual, demand);
        if (further.isPresent() && !Cause.codes(told).contains(further.get()))
            said = said.and(alike(further.get(), told));
        return new Finding(
                GradingVerdict.WRONG, said, grading.pictures(input, beside, actual), causes);
    }

    /** Why the right method refuses the input; empty where it has a right answer. */
    private Optional<String> refusal() {
        if (!demand.mayRefuse()) return Optional.empty();
        try {
            topic().record(grading.whole(grading.plain()), input, topic().mostItems());
            return Optional.empty();
        } catch (LimitReached answered) {
            return Optional.empty();
        } catch (IllegalArgumentException refused) {
            return Optional.of(refused.getMessage());
        }
    }

    /** One answer alone does not tell whether all come by a change of the right ones. */
    private static boolean areChanges(List<List<Cause>> causes) {
        return causes.stream().flatMap(List::stream).map(Cause::code).anyMatch(KnownChanges::isOne);
    }

    /** Tells the value by which a right method decides on the item that is told to differ. */
    private Message decided(O right, O actual, Message differs) {
        DifferingItem at =
                grading.differing(input, right, actual, differs).orElse(DifferingItem.WHOLE);
        return Decisions.of(topic().name(), input(), grading.json(input, right), at);
    }

    /** A method that gives the same answer; its faults too, where they alone explain it. */
    private Message alike(String method, List<Cause> told) {
        return told.isEmpty() ? grading.knownFault(method) : Message.of("known-fault", method);
    }

    @Override
    public JsonNode input() {
        return grading.json(input);
    }

    @Override
    public JsonNode exact() {
        return grading.json(input, truth(demand.items()));
    }

    private O right(O actual) {
        return grading.right(input, () -> truth(demand.items()), actual, demand);
    }

    /** Whether the input has a right answer: it may be made of a method's answer, or smaller. */
    boolean isAnswered() {
        try {
            truth(demand.items());
            return true;
        } catch (IllegalArgumentException refused) {
            return false;
        }
    }

    @Override
    @SuppressWarnings("unchecked") // recorded by this class
    public OptionalDouble error(Object output) {
        if (demand.cut()) return OptionalDouble.empty();
        O actual = (O) output;
        Deviation deviation = topic().compare(input, right(actual), actual);
        boolean told = deviation.worst() > 0 || topic().correct(deviation);
        return OptionalDouble.of(told ? deviation.worst() : Double.POSITIVE_INFINITY);
    }

    private O truth(int most) {
        if (most != demand.items()) return grading.truth(input, demand.tolerance(), most);
        if (truth == null) truth = grading.truth(input, demand.tolerance(), most);
        return truth;
    }

    @Override
    public boolean isRightWith(String mistake) {
        return known.isRightWith(mistake);
    }

    @Override
    @SuppressWarnings("unchecked") // recorded by this class
    public boolean comesBySlip(String slip, Answer answer) {
        return answer.output().filter(one -> known.comesBySlip(slip, (O) one)).isPresent();
    }

    @Override
    @SuppressWarnings("unchecked") // recorded by this class
    public boolean comesBy(String change, Answer answer) {
        return answer.output().map(output -> known.comesBy(change, (O) output)).orElse(true);
    }

    @Override
    public Set<String> traits() {
        Set<String> traits = new LinkedHashSet<>(grading.traits(input));
        if (demand.cut()) traits.add("cut");
        return traits;
    }

    @Override
    public Message example() {
        return grading.example(input);
    }

    @Override
    public String scene(Optional<Answer> wrong) {
        return new MethodCase(
                        topic().name(),
                        grading.method().or(this::rightMethod),
                        Leaves.json(topic().format(), input),
                        wrong.flatMap(grading::drawn))
                .write();
    }

    /** The first method that is right on this input; empty where all fail. */
    private Optional<String> rightMethod() {
        O right = truth(topic().mostItems());
        return topic().methods().stream()
                .filter(one -> !one.faulty())
                .filter(one -> isRight(one.implementation(), right))
                .map(Method::name)
                .findFirst();
    }

    private boolean isRight(C method, O right) {
        try {
            O output = topic().record(method, input, topic().mostItems());
            return topic().correct(topic().compare(input, right, output));
        } catch (LimitReached | IllegalArgumentException refused) {
            return false;
        }
    }
}
