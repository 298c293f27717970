package rasterlab.app.coordinates.list;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNull;

import java.util.ArrayList;
import java.util.List;
import java.util.stream.Stream;
import javax.swing.JLabel;
import javax.swing.JList;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import rasterlab.app.canvas.widget.NameChooser;
import rasterlab.app.language.Language;
import rasterlab.app.language.Texts;

class ListInspectorTest {
    private final List<Throwable> failures = new ArrayList<>();

    @ParameterizedTest(name = "a list that is no example has no name: {0}")
    @CsvSource({"ENGLISH, a list of one’s own, shear", "RUSSIAN, своя цепочка, перекос"})
    void changedExampleIsNamedAsOnesOwn(Language language, String own, String shear) {
        try (var model = new ListLabModel(Runnable::run, failures::add)) {
            Texts texts = Texts.of("coordinates.list", language);
            var inspector = new ListInspector(model, texts, column -> {});
            NameChooser examples = examples(inspector);
            model.show(Example.SHEAR);
            inspector.refresh();
            assertEquals(shear, chooserText(examples));
            model.remove();
            inspector.refresh();
            assertEquals(own, chooserText(examples));
            assertNull(examples.getToolTipText(), "a word of the program");
            ListChoice changed = model.choice();
            examples.setSelectedItem(examples.getSelectedItem());
            assertEquals(changed, model.choice(), "what is shown was chosen once more");
            model.history().undo();
            inspector.refresh();
            assertEquals(shear, chooserText(examples));
            assertEquals(Example.values().length, examples.getItemCount());
        }
        assertEquals(List.of(), failures);
    }

    private static NameChooser examples(ListInspector inspector) {
        return Stream.of(inspector.column().getComponents())
                .filter(NameChooser.class::isInstance)
                .map(NameChooser.class::cast)
                .filter(each -> "example".equals(each.getName()))
                .findFirst()
                .orElseThrow();
    }

    private static String chooserText(NameChooser chooser) {
        var cell =
                chooser.getRenderer()
                        .getListCellRendererComponent(
                                new JList<>(),
                                (String) chooser.getSelectedItem(),
                                -1,
                                false,
                                false);
        return ((JLabel) cell).getText();
    }
}
