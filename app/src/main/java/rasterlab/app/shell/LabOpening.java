package rasterlab.app.shell;

import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.function.Consumer;
import rasterlab.app.canvas.OpenInLab;
import rasterlab.app.clip.ClipMode;
import rasterlab.app.line.LineInput;
import rasterlab.app.spline.SplineMode;
import rasterlab.engine.naming.Named;
import rasterlab.engine.study.Hazard;

/** Opens inputs of topics in their tabs. A further topic is one more line in the constructor. */
final class LabOpening implements OpenInLab {
    /** Brings something to a model. */
    private interface Show {
        /**
         * @param what a hazard's name, or an input in JSON
         */
        void accept(String what, String method);
    }

    private record Way(String tab, Show show) {}

    private final Map<String, Way> hazards = new TreeMap<>();
    private final Map<String, Way> inputs = new TreeMap<>();
    private Consumer<String> showTab = tab -> {};

    LabOpening(LabModels models) {
        hazards.put("line", new Way("line", (name, method) -> line(models, name, method)));
        inputs.put("line", new Way("line", (json, method) -> lineInput(models, json, method)));
        for (ClipMode mode : ClipMode.values())
            hazards.put(
                    mode.topic(),
                    new Way("clip", (name, method) -> clip(models, mode, name, method)));
        hazards.put("curve", new Way("spline", (name, method) -> curve(models, name, method)));
        hazards.put(
                "spline-function",
                new Way("spline", (name, method) -> function(models, name, method)));
    }

    /**
     * @param next brings the tab of that name to the front
     */
    void showTabsBy(Consumer<String> next) {
        showTab = next;
    }

    @Override
    public boolean showsHazards(String topic) {
        return hazards.containsKey(topic);
    }

    @Override
    public void showHazard(String topic, String hazard, String method) {
        show(topic, hazards, hazard, method);
    }

    @Override
    public boolean showsInputs(String topic) {
        return inputs.containsKey(topic);
    }

    @Override
    public void showInput(String topic, String json, String method) {
        show(topic, inputs, json, method);
    }

    private void show(String topic, Map<String, Way> ways, String what, String method) {
        Way way =
                Named.find("tab of topic", topic, List.copyOf(ways.entrySet()), Map.Entry::getKey)
                        .getValue();
        way.show().accept(what, method);
        showTab.accept(way.tab());
    }

    private static <I> I input(List<Hazard<I>> hazards, String name) {
        return Named.<Hazard<I>>find("hazard", name, hazards, Hazard::name).input();
    }

    private static void line(LabModels models, String hazard, String method) {
        models.line().show(input(models.line().hazards(), hazard));
        models.line().chooseMethod(method);
    }

    private static void lineInput(LabModels models, String json, String method) {
        models.line().show(LineInput.read(json));
        if (!method.isEmpty()) models.line().chooseMethod(method);
    }

    private static void clip(LabModels models, ClipMode mode, String hazard, String method) {
        models.clip().show(mode, hazard);
        models.clip().chooseMethod(method);
    }

    private static void curve(LabModels models, String hazard, String method) {
        models.spline().show(SplineMode.CURVE);
        models.spline().curve().show(input(models.spline().curve().hazards(), hazard));
        models.spline().curve().chooseMethod(method);
    }

    private static void function(LabModels models, String hazard, String method) {
        models.spline().show(SplineMode.FUNCTION);
        models.spline().function().show(input(models.spline().function().hazards(), hazard));
        models.spline().function().chooseMethod(method);
    }
}
