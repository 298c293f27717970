package rasterlab.tests.build;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Set;
import java.util.TreeMap;
import java.util.TreeSet;

/**
 * The description of a build, in words that both builds share.
 *
 * @param modules by name, in no order
 * @param excluded what libraries want and do not get, {@code group:artifact}
 * @param project version of Rasterlab itself
 * @param javaLevel language level of Java
 * @param kotlin version of the Kotlin compiler
 * @param kotlinTarget byte-code level of Kotlin
 * @param slow the tag of the tests that {@code -Pquick} leaves out
 */
record BuildDescription(
        Map<String, Module> modules,
        Set<String> excluded,
        String project,
        String javaLevel,
        String kotlin,
        String kotlinTarget,
        String slow) {

    /**
     * @param dependencies {@code group:artifact} (a module of ours: its name) to version and scope
     * @param mainClass empty where the module has none
     * @param tests how its tests are run
     */
    record Module(Map<String, Dependency> dependencies, String mainClass, Processes tests) {}

    /**
     * @param scope {@code compile}, {@code provided} (while compiling only), {@code runtime} or
     *     {@code test}
     */
    record Dependency(String version, String scope) {}

    /** One line for each difference, naming its place; empty when both say the same. */
    List<String> differencesTo(BuildDescription other) {
        var differences = new ArrayList<String>();
        compare("excluded libraries", excluded, other.excluded, differences);
        compare("version of the project", project, other.project, differences);
        compare("Java level", javaLevel, other.javaLevel, differences);
        compare("Kotlin version", kotlin, other.kotlin, differences);
        compare("Kotlin target", kotlinTarget, other.kotlinTarget, differences);
        compare("tests left out by -Pquick", slow, other.slow, differences);
        compare("modules", modules.keySet(), other.modules.keySet(), differences);
        for (var name : common(modules, other.modules)) {
            var mine = modules.get(name);
            var theirs = other.modules.get(name);
            compare(name + ": main class", mine.mainClass, theirs.mainClass, differences);
            compareTests(name, mine.tests, theirs.tests, differences);
            for (var key : all(mine.dependencies, theirs.dependencies))
                compare(
                        name + ": dependency " + key,
                        mine.dependencies.get(key),
                        theirs.dependencies.get(key),
                        differences);
        }
        return differences;
    }

    private static void compareTests(
            String module, Processes mine, Processes theirs, List<String> into) {
        compare(module + ": test processes", mine.count(), theirs.count(), into);
        compare(module + ": seconds for tests", mine.seconds(), theirs.seconds(), into);
        var options = new TreeSet<>(mine.options());
        options.addAll(theirs.options());
        for (var option : options)
            compare(
                    module + ": option of tests " + option,
                    given(mine, option),
                    given(theirs, option),
                    into);
    }

    private static String given(Processes tests, String option) {
        return tests.options().contains(option) ? "given" : "not given";
    }

    private static void compare(String place, Object mine, Object theirs, List<String> into) {
        if (!Objects.equals(mine, theirs)) into.add(place + ": " + mine + " against " + theirs);
    }

    private static Set<String> common(Map<String, ?> left, Map<String, ?> right) {
        var names = new TreeSet<>(left.keySet());
        names.retainAll(right.keySet());
        return names;
    }

    private static Set<String> all(Map<String, ?> left, Map<String, ?> right) {
        var names = new TreeMap<String, Object>(left);
        names.putAll(right);
        return names.keySet();
    }
}
