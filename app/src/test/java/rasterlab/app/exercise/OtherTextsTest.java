package rasterlab.app.exercise;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import rasterlab.app.language.Language;
import rasterlab.app.language.Texts;
import rasterlab.exercises.Exercise;
import rasterlab.exercises.catalogue.Catalogue;
import rasterlab.exercises.folder.NewFolder;

class OtherTextsTest {
    private static final Exercise CIRCLE = Catalogue.builtIn().named("circle");

    @TempDir Path folder;

    private static List<String> others(Trial trial) {
        return trial.state().otherDrafts().stream().map(DraftFile.Other::text).toList();
    }

    private static String trialText(Trial trial) {
        return trial.state().notice().in(Texts.of("exercise", Language.ENGLISH));
    }

    @Test
    void textOfAFileTakesThePlaceOfTheKeptOneWhichIsOfferedAgain() throws Exception {
        try (var before = new Trial(folder)) {
            before.model.choose(CIRCLE.id());
            before.model.type("mine so far");
        }
        try (var trial = new Trial(folder)) {
            new OtherTexts(trial.model).open(CIRCLE, "of the file", "Circle.java");
            assertEquals(CIRCLE, trial.state().exercise());
            assertEquals("of the file", trial.state().source());
            assertEquals(List.of("mine so far"), others(trial));
            assertTrue(trialText(trial).contains("Circle.java"), trialText(trial));
            assertTrue(trialText(trial).contains("Other draft"), trialText(trial));
            trial.model.unsavedDrafts();
        }
        try (var again = new Trial(folder)) {
            again.model.choose(CIRCLE.id());
            assertEquals("of the file", again.state().source());
            assertEquals(List.of("mine so far"), others(again));
        }
    }

    @Test
    void starterAndTheSameTextAreNotKeptTwice() {
        try (var trial = new Trial(folder)) {
            var texts = new OtherTexts(trial.model);
            texts.open(CIRCLE, "of the file", "Circle.java");
            texts.open(CIRCLE, "of the file", "Circle.java");
            assertEquals(List.of(), others(trial));
            assertEquals("This is the text of the file Circle.java.", trialText(trial));
            texts.open(CIRCLE, "another", "Circle.java");
            texts.open(CIRCLE, "of the file", "Circle.java");
            texts.open(CIRCLE, "another", "Circle.java");
            assertEquals(List.of("of the file"), others(trial));
        }
    }

    @Test
    void keptTextStaysWhereThereIsNoPlaceBesideIt() throws Exception {
        Path drafts = Files.createDirectories(folder.resolve("drafts"));
        for (int i = 2; i <= DraftFile.MOST; i++)
            Files.writeString(drafts.resolve(CIRCLE.id() + "." + i + ".java"), "text " + i);
        try (var trial = new Trial(folder)) {
            trial.model.choose(CIRCLE.id());
            trial.model.type("mine so far");
            new OtherTexts(trial.model).open(CIRCLE, "of the file", "Circle.java");
            assertEquals("mine so far", trial.state().source());
            assertTrue(trialText(trial).startsWith("This is still your text"), trialText(trial));
        }
    }

    @Test
    void exerciseOfAnotherFolderIsAmongTheOthers() throws Exception {
        Path own = Files.createDirectories(folder.resolve("own").resolve("my-circle"));
        for (Map.Entry<String, String> file : NewFolder.files("circle").entrySet())
            Files.writeString(own.resolve(file.getKey()), file.getValue());
        Exercise mine = Catalogue.builtIn().withFolder(own.getParent()).named("my-circle");
        try (var trial = new Trial(folder)) {
            new OtherTexts(trial.model).open(mine, "of the file", "Mine.java");
            assertEquals(mine, trial.state().exercise());
            trial.model.choose(CIRCLE.id());
            trial.model.choose("my-circle");
            assertEquals("of the file", trial.state().source());
        }
    }
}
