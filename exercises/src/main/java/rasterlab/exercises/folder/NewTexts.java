package rasterlab.exercises.folder;

import static java.util.stream.Collectors.joining;

import java.lang.reflect.Method;
import java.lang.reflect.Modifier;
import java.lang.reflect.Parameter;
import java.util.Comparator;
import java.util.List;
import java.util.Set;
import java.util.TreeSet;
import java.util.stream.Stream;

/** The texts and sources of an exercise to begin with. */
final class NewTexts {
    private NewTexts() {}

    static String english(String title, Class<?> contract) {
        return """
        # %s

        Write a class that …

        ## What to build

        One public class, no package line, that implements `%s`. You may call it what you like;
        it needs a constructor without parameters (if you write none, Java gives it one).

            %s

        ## What is right

        The rule on ties and borders, the tolerance and its unit, formulas such as $x^2 + y^2 = r^2$, and an example with numbers.
        """
                .formatted(title, contract.getName(), signatures(contract));
    }

    static String russian(String title, Class<?> contract) {
        return """
        # %s

        Напишите класс, который …

        ## Что сделать

        Один публичный (public) класс без строки package, реализующий `%s`. Имя — любое;
        нужен конструктор без параметров (если не написать никакого, Java добавит его сама).

            %s

        ## Что считается верным

        Правило для границ и равенств, допуск и его единица, формулы вида $x^2 + y^2 = r^2$ и пример с числами.
        """
                .formatted(title, contract.getName(), signatures(contract));
    }

    static String englishHints() {
        return """
        ## 1

        The idea …

        ## 2

        Where to look, and the value that decides …

        ## 3

        Nearly the program, in words …
        """;
    }

    static String russianHints() {
        return """
        ## 1

        Идея …

        ## 2

        Куда смотреть и какая величина решает …

        ## 3

        Почти вся программа, но словами …
        """;
    }

    /** A class that implements the contract and does nothing. */
    static String source(Class<?> contract, String name) {
        String imports =
                imports(contract).stream().map("import %s;\n"::formatted).collect(joining());
        String methods = methods(contract).stream().map(NewTexts::empty).collect(joining("\n"));
        return "%s\n/** Does nothing so far. */\npublic class %s implements %s {\n%s}\n"
                .formatted(imports, name, contract.getSimpleName(), methods);
    }

    private static String empty(Method method) {
        String result = nothing(method.getReturnType());
        return "    @Override\n    public %s {%s}\n"
                .formatted(
                        signature(method),
                        result.isEmpty() ? "" : "\n        return " + result + ";\n    ");
    }

    /** The methods that a class has to implement, by name. */
    private static List<Method> methods(Class<?> contract) {
        return Stream.of(contract.getMethods())
                .filter(one -> Modifier.isAbstract(one.getModifiers()))
                .sorted(Comparator.comparing(Method::getName))
                .toList();
    }

    /** The signatures of the methods, a line each, as code within a text. */
    private static String signatures(Class<?> contract) {
        return methods(contract).stream().map(NewTexts::signature).collect(joining("\n    "));
    }

    private static String signature(Method method) {
        return method.getReturnType().getSimpleName()
                + " "
                + method.getName()
                + Stream.of(method.getParameters())
                        .map(NewTexts::parameter)
                        .collect(joining(", ", "(", ")"));
    }

    private static String parameter(Parameter one) {
        return one.getType().getSimpleName() + " " + one.getName();
    }

    private static Set<String> imports(Class<?> contract) {
        Set<String> names = new TreeSet<>(Set.of(contract.getName()));
        methods(contract).stream()
                .flatMap(
                        one ->
                                Stream.concat(
                                        Stream.of(one.getReturnType()),
                                        Stream.of(one.getParameterTypes())))
                .map(NewTexts::innermost)
                .filter(type -> !type.isPrimitive() && !type.getName().startsWith("java.lang."))
                .map(Class::getCanonicalName)
                .forEach(names::add);
        return names;
    }

    private static Class<?> innermost(Class<?> type) {
        return type.isArray() ? innermost(type.getComponentType()) : type;
    }

    /** The least that can be returned. */
    private static String nothing(Class<?> type) {
        if (type == void.class) return "";
        if (type == boolean.class) return "false";
        if (type.isPrimitive()) return "0";
        if (!type.isArray()) return "null";
        String sizes = type.getComponentType().isArray() ? "[0][]" : "[0]";
        return "new " + innermost(type).getSimpleName() + sizes;
    }
}
