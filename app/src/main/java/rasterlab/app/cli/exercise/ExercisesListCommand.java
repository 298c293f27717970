package rasterlab.app.cli.exercise;

import com.fasterxml.jackson.core.JsonGenerator;
import java.io.IOException;
import java.util.List;
import java.util.concurrent.Callable;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Option;
import rasterlab.app.cli.console.Console;
import rasterlab.app.cli.console.PrettyJson;
import rasterlab.app.cli.console.TextTable;
import rasterlab.app.language.Texts;
import rasterlab.app.outcome.ExitCode;
import rasterlab.exercises.Exercise;
import rasterlab.exercises.Exercise.PointPlan;
import rasterlab.exercises.course.Chapter;
import rasterlab.exercises.score.Disclosure;

/** Lists the exercises. */
@Command(
        name = "list",
        mixinStandardHelpOptions = true,
        description = {
            "Lists the exercises of the course.",
            "Tells of each its topic, kind, points, usual minutes and cases, and the lab that prepares.",
        },
        exitCodeListHeading = "%nExit codes:%n",
        exitCodeList = {
            "0:the exercises were listed",
            "2:the folder with exercises cannot be read, or one of them is wrong"
        },
        footer = {"", "Example: ./lab exercises list"})
final class ExercisesListCommand implements Callable<Integer> {
    private final Console console;

    @Option(names = "--json", description = "prints one JSON object instead of a table")
    private boolean json;

    @Mixin private ExercisesOption exercises;

    ExercisesListCommand(Console console) {
        this.console = console;
    }

    @Override
    public Integer call() throws IOException {
        List<Exercise> all = exercises.catalogue(console).all();
        if (json) writeJson(all);
        else print(all);
        return ExitCode.DONE;
    }

    private void print(List<Exercise> all) {
        Texts texts = console.language().texts();
        String language = console.language().code();
        var table =
                new TextTable(
                        texts.text("exercise"),
                        texts.text("list.topic"),
                        texts.text("list.kind"),
                        texts.text("points"),
                        texts.text("list.minutes"),
                        texts.text("list.open"),
                        texts.text("list.hidden"),
                        texts.text("list.lab"),
                        texts.text("list.title"));
        for (Exercise one : all)
            table.add(
                    List.of(
                            one.id(),
                            one.topic(),
                            one.form().code(),
                            "" + one.points().total(),
                            one.minutes().isPresent() ? "" + one.minutes().getAsInt() : "",
                            "" + open(one),
                            "" + (one.cases().size() - open(one)),
                            new Chapter(one.topic(), List.of(one)).labTitle(language),
                            one.title(language)));
        table.lines().forEach(console.out()::println);
    }

    private static int open(Exercise one) {
        return (int)
                one.cases().stream().filter(each -> each.visibility() == Disclosure.OPEN).count();
    }

    private void writeJson(List<Exercise> all) throws IOException {
        JsonGenerator out = PrettyJson.to(console.out());
        out.writeStartObject();
        out.writeArrayFieldStart("exercises");
        for (Exercise one : all) write(one, out);
        out.writeEndArray();
        out.writeEndObject();
        out.writeRaw('\n');
        out.close();
    }

    private static void write(Exercise one, JsonGenerator out) throws IOException {
        PointPlan plan = one.points();
        out.writeStartObject();
        out.writeStringField("id", one.id());
        out.writeStringField("topic", one.topic());
        out.writeStringField("kind", one.form().code());
        out.writeObjectFieldStart("title");
        out.writeStringField("en", one.title("en"));
        out.writeStringField("ru", one.title("ru"));
        out.writeEndObject();
        out.writeObjectFieldStart("points");
        out.writeNumberField("accuracy", plan.accuracy());
        out.writeNumberField("stability", plan.stability());
        out.writeNumberField("speed", plan.speed());
        out.writeEndObject();
        if (one.minutes().isPresent()) out.writeNumberField("minutes", one.minutes().getAsInt());
        out.writeStringField("lab", new Chapter(one.topic(), List.of(one)).lab());
        out.writeNumberField("openCases", open(one));
        out.writeNumberField("hiddenCases", one.cases().size() - open(one));
        out.writeStringField("revision", one.revision());
        out.writeEndObject();
    }
}
