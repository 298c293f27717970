package rasterlab.tests.rules;

import static org.junit.jupiter.api.Assertions.assertEquals;

import com.tngtech.archunit.core.domain.JavaAccess;
import com.tngtech.archunit.core.domain.JavaClass;
import com.tngtech.archunit.core.domain.JavaClasses;
import com.tngtech.archunit.core.domain.JavaMethod;
import com.tngtech.archunit.core.domain.JavaModifier;
import com.tngtech.archunit.core.importer.ClassFileImporter;
import com.tngtech.archunit.core.importer.ImportOption;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.TreeSet;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.DisplayName;
import org.junit.jupiter.api.Test;

/**
 * The product is what the product uses: what only tests or benchmarks name stands with them, and
 * what nobody names is deleted.
 *
 * <p>The contract is what students call, so it is not judged. Of Kotlin the compiler's own methods
 * and properties are left out: options, JSON and records of a database are set and read by
 * libraries.
 */
class ProductUseTest {
    /** Programs: Java itself starts them. */
    private static final Set<String> STARTED =
            Set.of("rasterlab.app.Main", "rasterlab.grader.MainKt");

    /** Where methods are judged. */
    private static final List<String> JUDGED =
            List.of("rasterlab.engine", "rasterlab.exercises", "rasterlab.app", "rasterlab.grader");

    /** Methods that Kotlin's compiler writes for properties and for classes of data. */
    private static final Pattern PROPERTY =
            Pattern.compile("(?:get|set|is)[A-Z].*|component\\d+.*|copy(?:-.*)?");

    private static JavaClasses product;

    @BeforeAll
    static void importClasses() {
        product =
                new ClassFileImporter()
                        .withImportOption(ImportOption.Predefined.DO_NOT_INCLUDE_TESTS)
                        .withImportOption(place -> !place.contains("/rasterlab/tests/"))
                        .importPackages("rasterlab");
    }

    @Test
    @DisplayName("a class of the product is named by tests alone, or by nobody")
    void everyClassIsUsed() {
        List<String> unused =
                product.stream()
                        .filter(type -> outermost(type).equals(type))
                        .filter(type -> !type.getSimpleName().equals("package-info"))
                        .filter(type -> !STARTED.contains(type.getName()))
                        .filter(type -> !isKotlin(type))
                        .filter(type -> !isNamed(type))
                        .map(JavaClass::getName)
                        .sorted()
                        .toList();
        assertEquals(
                List.of(),
                unused,
                "no class of the product names these: move them to the tests, use or delete them");
    }

    /** Constants are copied by the compiler, so a class of constants alone seems to be unnamed. */
    private static boolean isNamed(JavaClass type) {
        return type.getMethods().isEmpty()
                || withNested(type)
                        .flatMap(part -> part.getDirectDependenciesToSelf().stream())
                        .anyMatch(use -> !outermost(use.getOriginClass()).equals(type));
    }

    private static Stream<JavaClass> withNested(JavaClass type) {
        return product.stream().filter(part -> outermost(part).equals(type));
    }

    @Test
    @DisplayName("a method of the product is called by tests alone, or by nobody")
    void everyMethodIsUsed() {
        assertEquals(
                Set.of(),
                unusedMethods(),
                "no class of the product calls these: move them to the tests, use or delete them");
    }

    private static Set<String> unusedMethods() {
        return product.stream()
                .filter(type -> JUDGED.stream().anyMatch(type.getPackageName()::startsWith))
                .flatMap(type -> type.getMethods().stream())
                .filter(method -> !isCalled(method) && !isForOthers(method))
                .map(method -> method.getOwner().getSimpleName() + "." + method.getName())
                .collect(Collectors.toCollection(TreeSet::new));
    }

    private static boolean isCalled(JavaMethod method) {
        for (JavaAccess<?> access : method.getAccessesToSelf())
            if (!access.getOrigin().equals(method)) return true;
        return false;
    }

    /**
     * Whether the compiler writes the method, Java or a library calls it, or a caller knows it by a
     * wider type.
     */
    private static boolean isForOthers(JavaMethod method) {
        JavaClass owner = method.getOwner();
        return method.getModifiers().contains(JavaModifier.SYNTHETIC)
                || method.getModifiers().contains(JavaModifier.BRIDGE)
                || !method.getAnnotations().isEmpty()
                || owner.isRecord() && owner.tryGetField(method.getName()).isPresent()
                || owner.isEnum() && Set.of("values", "valueOf").contains(method.getName())
                || method.getName().equals("main")
                || isKotlin(owner) && PROPERTY.matcher(method.getName()).matches()
                || overrides(method);
    }

    private static boolean overrides(JavaMethod method) {
        return wider(method.getOwner().reflect())
                .flatMap(type -> Stream.of(type.getDeclaredMethods()))
                .anyMatch(
                        other ->
                                other.getName().equals(method.getName())
                                        && other.getParameterCount()
                                                == method.getParameters().size());
    }

    private static Stream<Class<?>> wider(Class<?> type) {
        return Stream.concat(
                        Stream.ofNullable(type.getSuperclass()), Stream.of(type.getInterfaces()))
                .flatMap(above -> Stream.concat(Stream.of(above), wider(above)));
    }

    private static JavaClass outermost(JavaClass type) {
        Optional<JavaClass> around = type.getEnclosingClass();
        return around.map(ProductUseTest::outermost).orElse(type);
    }

    private static boolean isKotlin(JavaClass type) {
        return type.getSource()
                .flatMap(source -> source.getFileName())
                .filter(name -> name.endsWith(".kt"))
                .isPresent();
    }
}
