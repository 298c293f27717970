package rasterlab.exercises.runner.scan;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.lang.reflect.Member;
import java.lang.reflect.Method;
import java.lang.reflect.Modifier;
import java.net.URI;
import java.nio.file.FileSystems;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Set;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.MethodSource;
import org.junit.jupiter.params.provider.ValueSource;
import rasterlab.contract.LineRasterizer;
import rasterlab.exercises.Contracts;

/** The list holds what is harmless and nothing that reaches out. */
class AllowListTest {
    private final AllowList list = AllowList.of(LineRasterizer.class);

    @ParameterizedTest(name = "harmless, but refused: {0}")
    @ValueSource(
            strings = {
                "java.util.PriorityQueue.poll",
                "java.util.ArrayDeque.push",
                "java.util.TreeMap.floorKey",
                "java.util.NavigableMap.floorKey",
                "java.util.LinkedHashMap.entrySet",
                "java.util.EnumMap.<init>",
                "java.util.EnumSet.noneOf",
                "java.util.BitSet.nextSetBit",
                "java.util.PrimitiveIterator$OfInt.nextInt",
                "java.util.OptionalDouble.getAsDouble",
                "java.util.Stack.push",
                "java.util.StringJoiner.add",
                "java.util.Arrays.stream",
                "java.util.List.stream",
                "java.util.stream.IntStream.rangeClosed",
                "java.util.stream.Collectors.toList",
                "java.lang.String.format",
                "java.lang.String.chars",
                "java.lang.System.lineSeparator",
                "java.lang.Object.getClass",
                "java.lang.Class.getSimpleName",
                "java.lang.Class.getName",
                "java.lang.Throwable.getCause",
                "java.lang.Exception.printStackTrace"
            })
    void allows(String use) {
        assertTrue(allowed(use));
    }

    @ParameterizedTest(name = "reaches out, but is allowed: {0}")
    @ValueSource(
            strings = {
                "java.lang.Class.forName",
                "java.lang.Class.getClassLoader",
                "java.lang.Class.getMethods",
                "java.lang.Class.getResourceAsStream",
                "java.lang.Class.newInstance",
                "java.lang.ClassLoader.getSystemClassLoader",
                "java.lang.Enum.describeConstable",
                "java.lang.Object.wait",
                "java.lang.Object.notifyAll",
                "java.lang.Process.destroy",
                "java.lang.Runtime.exec",
                "java.lang.StackWalker.getInstance",
                "java.lang.System.exit",
                "java.lang.System.getenv",
                "java.lang.System.getProperty",
                "java.lang.System.identityHashCode",
                "java.lang.System.setOut",
                "java.lang.Thread.<init>",
                "java.lang.ThreadLocal.<init>",
                "java.lang.Throwable.getStackTrace",
                "java.lang.Integer.getInteger",
                "java.lang.invoke.MethodHandles.lookup",
                "java.lang.ref.Cleaner.create",
                "java.lang.reflect.Method.invoke",
                "java.io.File.<init>",
                "java.io.ObjectInputStream.<init>",
                "java.io.PrintStream.<init>",
                "java.io.PrintStream.close",
                "java.io.Serializable.<init>",
                "java.net.Socket.<init>",
                "java.nio.file.Files.readString",
                "java.util.Arrays.parallelSort",
                "java.util.ArrayList.parallelStream",
                "java.util.Collections.shuffle",
                "java.util.Locale.setDefault",
                "java.util.Random.<init>",
                "java.util.Scanner.<init>",
                "java.util.ServiceLoader.load",
                "java.util.Timer.<init>",
                "java.util.WeakHashMap.<init>",
                "java.util.concurrent.Executors.newCachedThreadPool",
                "java.util.concurrent.CompletableFuture.runAsync",
                "java.util.stream.BaseStream.parallel",
                "java.util.stream.IntStream.parallel",
                "java.util.stream.Stream.parallel",
                "java.util.stream.StreamSupport.stream",
                "java.util.stream.Collectors.toConcurrentMap",
                "sun.misc.Unsafe.getUnsafe"
            })
    void refuses(String use) {
        assertFalse(allowed(use));
    }

    private boolean allowed(String use) {
        int dot = use.lastIndexOf('.');
        return list.allows(use.substring(0, dot).replace('.', '/'), use.substring(dot + 1));
    }

    @ParameterizedTest(name = "{0} leads to {1}")
    @CsvSource({
        "rasterlab.contract.LineRasterizer, rasterlab/contract/Pixels, plot",
        "rasterlab.contract.SegmentClipper, rasterlab/contract/SegmentSink, segment",
        "rasterlab.contract.FaceShader, rasterlab/contract/LitFace, corners",
        "rasterlab.contract.FaceShader, rasterlab/contract/SpotCone, shinesAllAround",
        "rasterlab.contract.PolygonFiller, rasterlab/contract/FillRule, NON_ZERO",
        "rasterlab.contract.PolygonFiller, rasterlab/contract/FillRule, ordinal",
        "rasterlab.contract.DepthFormat, rasterlab/contract/DepthRange, nearest",
        "rasterlab.contract.CurveTracer, rasterlab/contract/Curve$Kind, BEZIER"
    })
    void allowsTheTypesThatTheContractLeadsTo(Class<?> contract, String type, String member) {
        assertTrue(AllowList.of(contract).allows(type, member));
    }

    static List<Class<?>> contracts() {
        return Contracts.all();
    }

    /** A source may name what a method is given or asked for, and only what the contracts have. */
    @ParameterizedTest(name = "{0}")
    @MethodSource("contracts")
    void allowsWhatTheMethodsOfEveryContractTakeAndGiveBack(Class<?> contract) {
        AllowList all = AllowList.of(contract);
        for (Method method : contract.getMethods()) {
            List<Class<?>> types = new ArrayList<>(List.of(method.getParameterTypes()));
            types.add(method.getReturnType());
            for (Class<?> type : types) {
                Class<?> element = type;
                while (element.isArray()) element = element.getComponentType();
                if (element.isPrimitive()) continue;
                String name = element.getName().replace('.', '/');
                assertTrue(all.allows(name), method + " needs " + name);
                for (Method own : element.isRecord() ? element.getDeclaredMethods() : new Method[0])
                    if (Modifier.isPublic(own.getModifiers()))
                        assertTrue(all.allows(name, own.getName()), own.toString());
            }
        }
        Set<Class<?>> more = ContractTypes.of(contract);
        for (Class<?> type : more) assertEquals(contract.getPackage(), type.getPackage());
    }

    @ParameterizedTest(name = "{0} does not lead to {1}.{2}")
    @CsvSource({
        "rasterlab.contract.LineRasterizer, rasterlab/contract/LitFace, corners",
        "rasterlab.contract.PointInTriangle, rasterlab/contract/Pixels, plot",
        "rasterlab.contract.FaceShader, rasterlab/contract/Numbers, vector",
        "rasterlab.contract.FaceShader, rasterlab/contract/LitFace, nine",
        "rasterlab.contract.FaceShader, rasterlab/contract/LitFace, wait",
        "rasterlab.contract.PolygonFiller, rasterlab/contract/FillRule, describeConstable"
    })
    void refusesWhatTheContractDoesNotLeadTo(Class<?> contract, String type, String member) {
        assertFalse(AllowList.of(contract).allows(type, member));
    }

    @Test
    void allowsEveryFunctionInterface() throws IOException {
        Path folder =
                FileSystems.getFileSystem(URI.create("jrt:/"))
                        .getPath("/modules/java.base/java/util/function");
        try (Stream<Path> files = Files.list(folder)) {
            assertEquals(
                    List.of(),
                    files.map(file -> file.getFileName().toString().replace(".class", ""))
                            .filter(name -> !name.contains("package-info") && !name.contains("$"))
                            .filter(name -> !list.allows("java/util/function/" + name, "apply"))
                            .toList());
        }
    }

    @Test
    void namesNothingThatJavaDoesNotHave() throws ClassNotFoundException {
        List<String> unknown = new ArrayList<>();
        for (String line : AllowList.text().lines().toList()) {
            if (line.isBlank() || line.startsWith("#")) continue;
            String[] words = line.split("\\s+");
            Set<String> members = members(Class.forName(words[0]));
            for (int i = 1; i < words.length; i++) {
                String name = words[i].replaceFirst("^-", "");
                if (!name.equals("*") && !members.contains(name))
                    unknown.add(words[0] + "." + name);
            }
        }
        assertEquals(List.of(), unknown);
    }

    private static Set<String> members(Class<?> type) {
        Set<String> names = new HashSet<>(Set.of("<init>"));
        Stream.of(type.getMethods(), type.getDeclaredMethods(), type.getFields())
                .flatMap(Stream::<Member>of)
                .filter(one -> !Modifier.isPrivate(one.getModifiers()))
                .map(Member::getName)
                .forEach(names::add);
        return names;
    }
}
