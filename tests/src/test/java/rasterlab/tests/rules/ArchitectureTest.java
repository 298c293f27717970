package rasterlab.tests.rules;

import static com.tngtech.archunit.base.DescribedPredicate.not;
import static com.tngtech.archunit.core.domain.JavaClass.Predicates.belongToAnyOf;
import static com.tngtech.archunit.core.domain.JavaClass.Predicates.resideInAnyPackage;
import static com.tngtech.archunit.lang.syntax.ArchRuleDefinition.fields;
import static com.tngtech.archunit.lang.syntax.ArchRuleDefinition.noClasses;
import static com.tngtech.archunit.library.dependencies.SlicesRuleDefinition.slices;

import com.tngtech.archunit.core.domain.JavaClass;
import com.tngtech.archunit.core.domain.JavaClasses;
import com.tngtech.archunit.core.domain.JavaField;
import com.tngtech.archunit.core.domain.JavaModifier;
import com.tngtech.archunit.core.importer.ClassFileImporter;
import com.tngtech.archunit.core.importer.ImportOption;
import com.tngtech.archunit.lang.ArchCondition;
import com.tngtech.archunit.lang.ConditionEvents;
import com.tngtech.archunit.lang.SimpleConditionEvent;
import com.tngtech.archunit.library.dependencies.SliceAssignment;
import com.tngtech.archunit.library.dependencies.SliceIdentifier;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.DisplayName;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import rasterlab.engine.visibility.Cancellation;
import rasterlab.engine.visibility.ClipPlane;
import rasterlab.engine.visibility.FacePaint;
import rasterlab.engine.visibility.PixelPoint;
import rasterlab.engine.visibility.ViewedMesh;
import rasterlab.engine.visibility.Visibility;
import rasterlab.engine.visibility.VisibilityWork;

class ArchitectureTest {
    private static final String[] SWING = {"javax.swing..", "java.awt.event..", "com.formdev.."};

    private static JavaClasses classes;

    @BeforeAll
    static void importClasses() {
        classes =
                new ClassFileImporter()
                        .withImportOption(ImportOption.Predefined.DO_NOT_INCLUDE_TESTS)
                        // What JMH writes around a benchmark while it is compiled.
                        .withImportOption(place -> !place.contains("/jmh_generated/"))
                        .importPackages("rasterlab");
    }

    @Test
    void contractKnowsNothingButItself() {
        noClasses()
                .that()
                .resideInAPackage("rasterlab.contract..")
                .should()
                .dependOnClassesThat()
                .resideOutsideOfPackages("rasterlab.contract..", "java.lang..")
                .because(
                        "students import the contract alone: move the class there, or the use elsewhere")
                .check(classes);
    }

    @Test
    void engineKnowsNoOtherModule() {
        noClasses()
                .that()
                .resideInAnyPackage("rasterlab.engine..")
                .should()
                .dependOnClassesThat()
                .resideInAnyPackage(
                        "rasterlab.exercises..", "rasterlab.app..", "rasterlab.grader..")
                .because("the engine is used by the other modules: pass in what it needs")
                .check(classes);
    }

    @Test
    void engineShowsNoWindow() {
        noClasses()
                .that()
                .resideInAnyPackage(
                        "rasterlab.engine..", "rasterlab.exercises..", "rasterlab.grader..")
                .should()
                .dependOnClassesThat()
                .resideInAnyPackage(SWING)
                .because("only the app has a window: move the use there")
                .check(classes);
    }

    @Test
    void exercisesKnowNeitherAppNorGrader() {
        noClasses()
                .that()
                .resideInAPackage("rasterlab.exercises..")
                .should()
                .dependOnClassesThat()
                .resideInAnyPackage("rasterlab.app..", "rasterlab.grader..")
                .because("app and grader use the exercises: pass in what they need")
                .check(classes);
    }

    @Test
    void appAndGraderNeverSeeEachOther() {
        noClasses()
                .that()
                .resideInAPackage("rasterlab.app..")
                .should()
                .dependOnClassesThat()
                .resideInAPackage("rasterlab.grader..")
                .because("they share exercises and engine only: move the class there")
                .check(classes);
        noClasses()
                .that()
                .resideInAPackage("rasterlab.grader..")
                .should()
                .dependOnClassesThat()
                .resideInAPackage("rasterlab.app..")
                .because("they share exercises and engine only: move the class there")
                .check(classes);
    }

    /** The code beside a student's must not carry references or expected values with it. */
    @Test
    void childKnowsOnlyTheContract() {
        noClasses()
                .that()
                .resideInAPackage("rasterlab.exercises.child..")
                .should()
                .dependOnClassesThat()
                .resideOutsideOfPackages(
                        "rasterlab.exercises.child..",
                        "rasterlab.contract..",
                        "java..",
                        "javax.tools..")
                .because("a student's code could read it: send what the child needs over the wire")
                .check(classes);
    }

    @Test
    void modelsOfTheLabsKnowNoSwing() {
        noClasses()
                .that()
                .resideInAPackage("rasterlab.app..")
                .and()
                .haveSimpleNameEndingWith("Model")
                .should()
                .dependOnClassesThat()
                .resideInAnyPackage(SWING)
                .because("a model is tested without a window: move the use to the panel")
                .check(classes);
    }

    @Test
    @DisplayName("packages form a circle, of a module or of its tests")
    void noPackagesFormACircle() {
        var compiled = CompiledClasses.read();
        slices().assignedFrom(packagesOf(compiled))
                .should()
                .beFreeOfCycles()
                .because("a reader starts below: move the class that closes the circle")
                .check(compiled.all());
    }

    /** A feature with all that is in it is one box of the map. */
    @ParameterizedTest(name = "packages right below {0} form a circle")
    @ValueSource(strings = {"engine", "exercises", "app", "grader"})
    void packagesOfOneModuleFormNoCircle(String module) {
        slices().assignedFrom(topPackagesOf("rasterlab." + module))
                .should()
                .beFreeOfCycles()
                .because("a reader starts below: move the class that closes the circle")
                .check(classes);
    }

    @Test
    void packagesOfClippingFormNoCircle() {
        slices().assignedFrom(topPackagesOf("rasterlab.engine.clip"))
                .should()
                .beFreeOfCycles()
                .because("a reader starts below: move the class that closes the circle")
                .check(classes);
    }

    /** The references share no code with the methods they judge. */
    @Test
    void exactClippingKnowsNoMethod() {
        noClasses()
                .that()
                .resideInAPackage("rasterlab.engine.clip.exact..")
                .should()
                .dependOnClassesThat()
                .resideOutsideOfPackages("rasterlab.engine.clip.exact..", "java..")
                .because(
                        "a reference shares no code with the methods that it judges: write it anew")
                .check(classes);
    }

    /** The reference has only its arguments and its answer in common with the methods. */
    @Test
    void exactVisibilityKnowsNoMethod() {
        noClasses()
                .that()
                .resideInAPackage("rasterlab.engine.visibility.exact..")
                .should()
                .dependOnClassesThat(
                        resideInAnyPackage("rasterlab.engine.visibility..")
                                .and(not(resideInAnyPackage("rasterlab.engine.visibility.exact..")))
                                .and(
                                        not(
                                                belongToAnyOf(
                                                        Visibility.class,
                                                        VisibilityWork.class,
                                                        ViewedMesh.class,
                                                        ClipPlane.class,
                                                        FacePaint.class,
                                                        PixelPoint.class,
                                                        Cancellation.class))))
                .because(
                        "a reference shares no code with the methods that it judges: write it anew")
                .check(classes);
    }

    /**
     * Each package by its full name, without those below it. A unit test may use what stands above
     * the package under test, so the tests of a package are compared apart from it; the module of
     * tests is compared as a whole.
     */
    private static SliceAssignment packagesOf(CompiledClasses compiled) {
        return new SliceAssignment() {
            @Override
            public SliceIdentifier getIdentifierOf(JavaClass one) {
                String name = one.getPackageName();
                if (!name.startsWith("rasterlab.")) return SliceIdentifier.ignore();
                boolean apart = compiled.isTest(one) && !name.startsWith("rasterlab.tests");
                return SliceIdentifier.of(apart ? "tests of " + name : name);
            }

            @Override
            public String getDescription() {
                return "each package of all modules, and the tests of each";
            }
        };
    }

    /** Each package right below the module's root with all that is in it, and the root itself. */
    private static SliceAssignment topPackagesOf(String root) {
        return new SliceAssignment() {
            @Override
            public SliceIdentifier getIdentifierOf(JavaClass one) {
                String name = one.getPackageName();
                if (name.equals(root)) return SliceIdentifier.of(root);
                if (!name.startsWith(root + ".")) return SliceIdentifier.ignore();
                return SliceIdentifier.of(name.substring(root.length() + 1).split("\\.")[0]);
            }

            @Override
            public String getDescription() {
                return root + " and the packages right below it";
            }
        };
    }

    @Test
    void noStaticFieldCanBeReassigned() {
        fields().that()
                .areStatic()
                .and()
                .areNotFinal()
                .should(beWrittenByTheCompiler())
                .because(
                        "two labs or requests would share it: make it final or a field of an object")
                .allowEmptyShould(true)
                .check(classes);
    }

    private static ArchCondition<JavaField> beWrittenByTheCompiler() {
        return new ArchCondition<>("be final or synthetic") {
            @Override
            public void check(JavaField field, ConditionEvents events) {
                var synthetic = field.getModifiers().contains(JavaModifier.SYNTHETIC);
                events.add(
                        new SimpleConditionEvent(
                                field,
                                synthetic,
                                field.getFullName() + " is static and not final"));
            }
        };
    }
}
