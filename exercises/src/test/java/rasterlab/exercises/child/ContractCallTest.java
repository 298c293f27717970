package rasterlab.exercises.child;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.ByteArrayOutputStream;
import java.io.DataInputStream;
import java.io.DataOutputStream;
import java.io.IOException;
import java.io.OutputStream;
import java.lang.reflect.Modifier;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.stream.Stream;
import org.junit.jupiter.api.Named;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import rasterlab.contract.CurveTracer;
import rasterlab.contract.MatrixFormula;
import rasterlab.contract.Pixels;
import rasterlab.contract.PolygonSink;
import rasterlab.engine.study.Hazard;
import rasterlab.engine.study.LimitReached;
import rasterlab.engine.study.Method;
import rasterlab.engine.study.Topic;
import rasterlab.exercises.Contracts;

/** Arguments and answers of a contract's method come over the wire as they are. */
class ContractCallTest {
    private static final int MOST = CalledHere.MOST;

    static Stream<Named<Topic<?, ?, ?>>> topics() {
        return Contracts.topics().stream().map(topic -> Named.of(topic.name(), topic));
    }

    /** Each right method is called as a child calls a student's, on each hazard it is right on. */
    @ParameterizedTest
    @MethodSource("topics")
    <C, I, O> void theAnswersOfAllTopicsArriveAsTheyAre(Topic<C, I, O> topic) throws Exception {
        Method<C> method = topic.methods().stream().filter(m -> !m.faulty()).findFirst().get();
        ContractCalls contract = ContractCalls.of(Contracts.of(topic));
        C remote = CalledHere.remote(contract, method.implementation(), CalledHere.calling());
        for (Hazard<I> hazard : topic.hazards()) {
            assertEquals(
                    outcome(topic, method.implementation(), hazard.input()),
                    outcome(topic, remote, hazard.input()),
                    hazard.name());
        }
    }

    /** How far the answer is from exact, or why there is none. */
    private static <C, I, O> String outcome(Topic<C, I, O> topic, C method, I input) {
        try {
            O exact = topic.exact(input, MOST);
            return topic.compare(input, exact, topic.record(method, input, MOST)).toString();
        } catch (IllegalArgumentException | LimitReached none) {
            return none.toString();
        }
    }

    /** Calls that were timed answer what the same calls answer one by one. */
    @ParameterizedTest
    @MethodSource("topics")
    <C, I, O> void theTimedAnswersOfAllTopicsArriveAsTheyAre(Topic<C, I, O> topic)
            throws Throwable {
        Method<C> method = topic.methods().stream().filter(m -> !m.faulty()).findFirst().get();
        ContractCalls contract = ContractCalls.of(Contracts.of(topic));
        int timed = 0;
        for (Hazard<I> hazard : topic.hazards()) {
            var payload = new ByteArrayOutputStream();
            List<byte[]> answers = new ArrayList<>();
            var there = new ArrayAliases();
            var here = new ArrayAliases();
            CalledHere.Answering listening =
                    (call, implementation, given) -> {
                        new DataOutputStream(payload).writeInt(call.number());
                        payload.write(CalledHere.sent(call, given));
                        byte[] answer = CalledHere.called(call, implementation, given, there);
                        answers.add(answer);
                        return CalledHere.replayed(call, answer, given, here);
                    };
            C recorded = CalledHere.remote(contract, method.implementation(), listening);
            try {
                topic.record(recorded, hazard.input(), MOST);
            } catch (IllegalArgumentException | LimitReached | Error notTimed) {
                continue;
            }
            int bytes = answers.stream().mapToInt(one -> one.length + Integer.BYTES).sum();
            if (bytes > Wire.MOST_ANSWER_BYTES / 16) continue;
            timed++;
            assertTimed(contract, method.implementation(), payload.toByteArray(), answers);
        }
        assertTrue(timed > 0, "no hazard is answered");
    }

    private static void assertTimed(
            ContractCalls contract, Object method, byte[] given, List<byte[]> answers)
            throws Throwable {
        var payload = new ByteArrayOutputStream();
        var out = new DataOutputStream(payload);
        for (int number :
                new int[] {answers.size(), MOST + 1, Wire.MOST_ANSWER_BYTES, 10, 0, answers.size()})
            out.writeInt(number);
        out.write(given);
        List<Calling> callings = new ArrayList<>();
        for (ContractCall call : contract.all())
            callings.add(
                    new Calling() {
                        @Override
                        Object call(Object student, Object[] arguments) throws Throwable {
                            return call.invoke(student, arguments);
                        }
                    });
        var calls = new TimedCalls(contract, callings, CalledHere.in(payload.toByteArray()));
        calls.run(method);
        var told = new ByteArrayOutputStream();
        calls.writeTo(new DataOutputStream(told), 7);
        DataInputStream in = CalledHere.in(told.toByteArray());
        assertTrue(in.readLong() >= 0, "items");
        in.readLong();
        assertEquals(7, in.readLong(), "printed");
        for (byte[] answer : answers)
            assertArrayEquals(answer, Frames.read(in, Wire.MOST_ANSWER_BYTES));
        assertEquals(0, in.available(), "bytes are left over");
    }

    @Test
    void theMethodsOfAContractHaveNumbers() throws IOException {
        ContractCalls calls = ContractCalls.of(CurveTracer.class);
        assertEquals(
                List.of("at", "flatten"),
                calls.all().stream().map(one -> one.method().getName()).toList());
        for (ContractCall one : calls.all()) assertSame(one, calls.numbered(one.number()));
        assertSame(calls.all().get(1), calls.of(calls.all().get(1).method()));
        for (int none : new int[] {-1, 2})
            assertThrows(IOException.class, () -> calls.numbered(none));
    }

    /** Could be within itself. */
    record Node(double number, Node[] next) {}

    /** Takes what has no end. */
    interface Endless {
        double sum(Node first);
    }

    @Test
    void anInterfaceThatCannotBeSentIsNoContract() {
        for (Class<?> none : List.of(Comparable.class, Cloneable.class, Endless.class))
            assertThrows(IllegalArgumentException.class, () -> ContractCalls.of(none));
    }

    @Test
    void aLengthBeyondTheFrameIsRefusedBeforeRoomIsMade() throws IOException {
        var answer = new ByteArrayOutputStream();
        var out = new DataOutputStream(answer);
        out.writeBoolean(true);
        out.writeInt(Integer.MAX_VALUE);
        assertThrows(
                IOException.class,
                () -> Values.read(double[].class, CalledHere.in(answer.toByteArray())));
        assertThrows(
                IOException.class,
                () -> Values.read(String.class, CalledHere.in(answer.toByteArray())));
    }

    /** Rows that are one and the same would be a million million numbers. */
    @Test
    void anAnswerIsCountedWhileItIsWritten() {
        double[][] rows = new double[1_000_000][];
        Arrays.fill(rows, new double[1_000_000]);
        ContractCall call = ContractCalls.of(MatrixFormula.class).all().get(0);
        assertThrows(
                BoundedBytes.Beyond.class,
                () ->
                        call.answer(
                                new byte[0],
                                List.of(),
                                new Object[] {"ID3D", new double[0]},
                                rows,
                                Wire.MOST_ANSWER_BYTES));
        var out = new DataOutputStream(OutputStream.nullOutputStream());
        assertThrows(
                BoundedBytes.Beyond.class,
                () -> Values.write(String.class, "x".repeat(Wire.MOST_FRAME_BYTES + 1), out));
    }

    /** A student could otherwise be given what nobody keeps. */
    @Test
    void thereIsASheetForEverySinkOfAContract() {
        List<Class<?>> sinks =
                Contracts.all().stream()
                        .flatMap(contract -> Stream.of(contract.getMethods()))
                        .filter(method -> Modifier.isAbstract(method.getModifiers()))
                        .flatMap(method -> Stream.of(method.getParameterTypes()))
                        .filter(Class::isInterface)
                        .distinct()
                        .toList();
        assertTrue(sinks.contains(Pixels.class) && sinks.contains(PolygonSink.class), "" + sinks);
        for (Class<?> sink : sinks) assertTrue(SinkSheets.isKept(sink), sink + " has no sheet");
    }
}
