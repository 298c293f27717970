package rasterlab.exercises.child;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.DataInputStream;
import java.io.DataOutputStream;
import java.io.IOException;
import java.lang.reflect.InvocationHandler;
import java.lang.reflect.Modifier;
import java.lang.reflect.Proxy;
import java.util.List;
import java.util.Set;
import java.util.stream.Stream;
import org.junit.jupiter.api.Named;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import rasterlab.contract.CurveTracer;
import rasterlab.contract.Pixels;
import rasterlab.contract.PolygonSink;
import rasterlab.engine.Topics;
import rasterlab.engine.study.Hazard;
import rasterlab.engine.study.LimitReached;
import rasterlab.engine.study.Method;
import rasterlab.engine.study.Topic;

/** Whatever a contract's method is given and answers comes over the wire as it is. */
class ContractCallTest {
    /** Contracts of two methods, or whose method returns an object with methods of its own. */
    private static final Set<String> NOT_CALLED =
            Set.of("curve", "depth-buffer", "texture-filter", "hidden-surfaces");

    private static final int MOST = 20_000;

    static Stream<Named<Topic<?, ?, ?>>> topics() {
        return Topics.all().stream()
                .filter(topic -> !NOT_CALLED.contains(topic.name()))
                .map(topic -> Named.of(topic.name(), topic));
    }

    /** Each right method is called as a child calls a student's, on each hazard it is right on. */
    @ParameterizedTest
    @MethodSource("topics")
    <C, I, O> void theAnswersOfAllTopicsArriveAsTheyAre(Topic<C, I, O> topic) throws Exception {
        Method<C> method = topic.methods().stream().filter(m -> !m.faulty()).findFirst().get();
        ContractCall contract = ContractCall.of(contract(topic));
        C remote = remote(contract, method.implementation());
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

    /** The interface of the contracts' package that the topic's methods implement. */
    private static Class<?> contract(Topic<?, ?, ?> topic) {
        Object implementation = topic.methods().get(0).implementation();
        return interfaces(implementation.getClass())
                .filter(type -> type.getPackageName().equals("rasterlab.contract"))
                .findFirst()
                .orElseThrow();
    }

    private static Stream<Class<?>> interfaces(Class<?> type) {
        if (type == null) return Stream.of();
        Stream<Class<?>> above =
                Stream.concat(Stream.of(type.getInterfaces()), Stream.of(type))
                        .filter(one -> one.isInterface());
        return Stream.concat(
                above.flatMap(
                        one ->
                                one == type
                                        ? Stream.of(one)
                                        : Stream.concat(Stream.of(one), interfaces(one))),
                interfaces(type.getSuperclass()));
    }

    @SuppressWarnings("unchecked") // the proxy is of the contract
    private static <C> C remote(ContractCall contract, C implementation) {
        Class<?> type = contract.contract();
        InvocationHandler handler =
                (proxy, method, given) ->
                        method.isDefault()
                                ? method.invoke(implementation, given)
                                : called(contract, implementation, given);
        return (C) Proxy.newProxyInstance(type.getClassLoader(), new Class<?>[] {type}, handler);
    }

    private static Object called(ContractCall contract, Object implementation, Object[] given)
            throws Throwable {
        var asked = new ByteArrayOutputStream();
        contract.writeArguments(given, new DataOutputStream(asked));
        Object[] there = contract.readArguments(in(asked), MOST + 1, 10);
        byte[] before = contract.values(there);
        Object returned = null;
        try {
            returned = contract.invoke(implementation, there);
        } catch (Error stopped) {
            if (Stream.of(there).noneMatch(one -> one instanceof Sheet sheet && sheet.full()))
                throw stopped;
        }
        var answer = new ByteArrayOutputStream();
        contract.writeAnswer(before, there, returned, new DataOutputStream(answer));
        DataInputStream in = in(answer);
        Object value = contract.replay(in, given).value();
        assertEquals(0, in.available(), "bytes are left over");
        return value;
    }

    private static DataInputStream in(ByteArrayOutputStream bytes) {
        return new DataInputStream(new ByteArrayInputStream(bytes.toByteArray()));
    }

    @Test
    void aContractOfTwoMethodsIsNotCalled() {
        var e =
                assertThrows(
                        IllegalArgumentException.class, () -> ContractCall.of(CurveTracer.class));
        assertEquals("CurveTracer must have one method to implement, got 2", e.getMessage());
    }

    @Test
    void aLengthBeyondTheFrameIsRefusedBeforeRoomIsMade() throws IOException {
        var answer = new ByteArrayOutputStream();
        var out = new DataOutputStream(answer);
        out.writeBoolean(true);
        out.writeInt(Integer.MAX_VALUE);
        assertThrows(IOException.class, () -> Values.read(double[].class, in(answer)));
        assertThrows(IOException.class, () -> Values.read(String.class, in(answer)));
    }

    /** Otherwise a student could be given what nobody keeps. */
    @Test
    void thereIsASheetForEverySinkOfAContract() {
        List<Class<?>> sinks =
                Topics.all().stream()
                        .filter(topic -> !topic.name().equals("hidden-surfaces"))
                        .<Class<?>>map(ContractCallTest::contract)
                        .flatMap(contract -> Stream.of(contract.getMethods()))
                        .filter(method -> Modifier.isAbstract(method.getModifiers()))
                        .flatMap(method -> Stream.of(method.getParameterTypes()))
                        .filter(Class::isInterface)
                        .distinct()
                        .toList();
        assertTrue(sinks.contains(Pixels.class) && sinks.contains(PolygonSink.class), "" + sinks);
        for (Class<?> sink : sinks) assertTrue(Sheets.isKept(sink), sink + " has no sheet");
    }
}
