package highway;

import highway.Observation.Aired;
import highway.Observation.Pin;
import highway.Observation.Printed;
import java.util.ArrayList;
import java.util.List;
import java.util.function.Predicate;
import java.util.stream.Stream;

/** One row of the scenario's table: what a device must be seen to do. All evidence must come, in any order. */
final class Behaviour {

    /** A piece of evidence, and the words for it when it is missing. */
    private record Evidence(String missing, Predicate<Observation> shows) {}

    final Device device;
    final String text;
    private final List<Evidence> awaited = new ArrayList<>();

    private Behaviour(Device device, String text) {
        this.device = device;
        this.text = text;
    }

    /** The rows of the table in this folder's README. */
    static List<Behaviour> all(boolean inspector) {
        return Stream.of(ofHighway(), inspector ? ofInspector() : List.<Behaviour>of()).flatMap(List::stream).toList();
    }

    /** The rows of the table in the inspector's README. */
    private static List<Behaviour> ofInspector() {
        return List.of(
                of(Device.SUPPORT, "its inspector leaves for the bus").says("I travel to ROMA").airsSealed("ROMA"),
                of(Device.BUS, "lets it in; it looks, and goes home").says("Welcome, inspector")
                        .says("On ROMA I see an obstacle").airsSealed("SUPP"),
                of(Device.SUPPORT, "has its inspector back, with what it saw").says("I am back from ROMA"));
    }

    private static List<Behaviour> ofHighway() {
        return List.of(
                of(Device.BUS, "collision: stops, alarms, broadcasts tell help")
                        .says("I have suffered an accident").pin("motor", 1).pin("motor", 0).pin("buzzer", 1)
                        .airsPlain("////", "tell;help"),
                of(Device.POLICE, "hears it, multicasts someoneNeedHelp to //SU")
                        .says("I got an accident message from ROMA").airsSealed("//SU"),
                of(Device.SUPPORT, "hears that, unicasts someoneNeedHelp to SUHO")
                        .says("I got a help message in the public safety group").airsSealed("SUHO"),
                of(Device.HOSPITAL, "hears that, unicasts someoneNeedAmbulance to SUAM")
                        .says("Asking for an ambulance").airsSealed("SUAM"),
                of(Device.AMBULANCE, "hears that, drives with siren, unicasts ambulanceIsComing to SUHO")
                        .says("I am going").pin("siren", 1).pin("motor", 1).airsSealed("SUHO"),
                of(Device.HOSPITAL, "unicasts ambulanceIsComing to SUPP")
                        .says("Sending an Ambulance").airsSealed("SUPP"),
                of(Device.SUPPORT, "unicasts helpComing to SUPO")
                        .says("I understood! The Ambulance is coming").airsSealed("SUPO"),
                of(Device.POLICE, "unicasts helpComing to ROMA")
                        .says("The help is coming").airsSealed("ROMA"),
                of(Device.BUS, "hears it: help is coming")
                        .says("Help is coming, says SUPO"));
    }

    private static Behaviour of(Device device, String text) {
        return new Behaviour(device, text);
    }

    private Behaviour says(String words) {
        return await("the agent did not say \"" + words + "\"",
                seen -> seen instanceof Printed line && line.device() == device && line.text().contains(words));
    }

    private Behaviour airsPlain(String destination, String content) {
        return await("no plain packet " + device.address + " → " + destination + " on the air",
                seen -> seen instanceof Aired aired && goes(aired, destination)
                        && !aired.sealed() && aired.content().equals(content));
    }

    private Behaviour airsSealed(String destination) {
        return await("no sealed packet " + device.address + " → " + destination + " on the air",
                seen -> seen instanceof Aired aired && goes(aired, destination) && aired.sealed());
    }

    private Behaviour pin(String name, int level) {
        return await(name + " not switched " + (level == 1 ? "on" : "off"),
                seen -> seen instanceof Pin pin && pin.device() == device
                        && pin.name().equals(name) && pin.level() == level);
    }

    private boolean goes(Aired aired, String destination) {
        return aired.origin().equals(device.address) && aired.destination().equals(destination);
    }

    private Behaviour await(String missing, Predicate<Observation> shows) {
        awaited.add(new Evidence(missing, shows));
        return this;
    }

    /** Takes note of what was seen: whether it is evidence that was still awaited. */
    boolean see(Observation observation) {
        return awaited.stream().filter(evidence -> evidence.shows.test(observation)).findFirst().map(awaited::remove)
                .orElse(false);
    }

    boolean observed() {
        return awaited.isEmpty();
    }

    /** The evidence that has not been seen yet. */
    List<String> missing() {
        return awaited.stream().map(Evidence::missing).toList();
    }
}
