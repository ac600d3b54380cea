/** Internal actions as agents for the Argo architecture write them: {@code .argo.port(P)}. */
package jason.stdlib.argo;
