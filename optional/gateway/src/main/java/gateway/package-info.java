/** Joins radio cells over MQTT. */
package gateway;
